#include "page/accuracy_view.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "page/table.hpp"
#include "page/words.hpp"
#include "report/classifier_rows.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/ratio_columns.hpp"
#include "report/verdict.hpp"

namespace piae::page {

namespace {

using report::AccuracyRow;

std::string published_label(const AccuracyRow& row, const report::PaperReference& reference,
                            report::NumberStyle style) {
  const std::optional<double> theirs = row.published ? row.published : row.orientation;
  return theirs ? reference.label() + " " + report::number_label(*theirs, style) : "";
}

Html line_of_cell(const std::string& looks, const std::string& text) {
  return text.empty() ? Html() : element("span", {{"class", looks}}, text);
}

/// Which artefacts a mean was made from.
std::string files_of(const AccuracyRow& row) {
  return fmt::format("{}/seed{{{}}}/{}/{}/{}/diagnosis.h5, attribute accuracy", row.dataset,
                     fmt::join(row.seeds, ","), row.method, row.ratio, row.classifier);
}

/// "3 of 10 seeds", where some of those that the grid has are missing.
std::string fewer_seeds(const AccuracyRow& row, std::size_t most) {
  return row.seeds.size() < most ? fmt::format("{} of {} seeds", row.seeds.size(), most) : "";
}

Cell accuracy_cell(const AccuracyRow& row, const report::PaperReference& reference,
                   std::size_t most) {
  return {.content = line_of_cell("ours", report::mean_label(row.summary)) +
                     line_of_cell("theirs", published_label(row, reference, {})) +
                     line_of_cell("theirs", fewer_seeds(row, most)),
          .number = row.summary.mean,
          .from = files_of(row)};
}

constexpr report::NumberStyle gain_style{.decimals = 2, .sign = true};

/// A sign and a class of the style sheet.
struct Sign {
  const char* sign;
  const char* looks;
};

Sign effect_sign(report::Effect effect) {
  switch (effect) {
    case report::Effect::helps:
      return {"▲ ", "helps"};
    case report::Effect::harms:
      return {"▼ ", "harms"};
    case report::Effect::no_clear_difference:
      break;
  }
  return {"○ ", "unclear"};
}

Cell gain_cell(const AccuracyRow& row, const report::PaperReference& reference, std::size_t most) {
  const Sign sign = effect_sign(report::effect_of(row));
  const std::string interval =
      row.summary.interval ? report::interval_label(row.summary, gain_style) : "";
  return {.content =
              line_of_cell("ours", sign.sign + report::number_label(row.summary.mean, gain_style)) +
              line_of_cell("theirs", interval) +
              line_of_cell("theirs", published_label(row, reference, gain_style)) +
              line_of_cell("theirs", fewer_seeds(row, most)),
          .number = row.summary.mean,
          .looks = sign.looks,
          .from = files_of(row) + ", minus that of none"};
}

/// A method in each row, a ratio in each column; then the bar, where it is known.
template <class CellOf>
Table table_by_ratio(const std::string& caption, const std::vector<AccuracyRow>& rows,
                     const std::optional<AccuracyRow>& bar, const CellOf& cell_of) {
  Table table{.caption = caption, .columns = {{"method"}}};
  std::vector<AccuracyRow> all = rows;
  if (bar) all.push_back(*bar);
  const std::vector<report::RatioColumn> columns = report::ratio_columns(all);
  for (const report::RatioColumn& column : columns) table.columns.push_back({column.label, true});
  const auto add_line = [&](const std::string& name, const std::vector<AccuracyRow>& own,
                            const std::string& looks) {
    Row line{.cells = {{.content = name}}, .looks = looks};
    for (const report::RatioColumn& column : columns) {
      const auto row = std::ranges::find(own, column.ratio, &AccuracyRow::ratio);
      line.cells.push_back(row == own.end() ? Cell{} : cell_of(*row));
    }
    table.rows.push_back(std::move(line));
  };
  for (const std::string& method : report::methods_of(rows)) {
    add_line(report::method_label(method), report::rows_of(rows, method),
             augment::is_ceiling(method) ? "ceiling" : "");
  }
  if (bar) add_line(report::bar_label(*bar), {*bar}, "");
  return table;
}

/// Behind the caption of a table: by which classifier, unless it is the paper's.
std::string by(const report::ClassifierRows& block) {
  return block.classifier == scoring::paper_classifier ? "" : ", by " + block.classifier;
}

std::string about_published(const report::PaperReference& reference,
                            const std::string& classifier) {
  if (classifier != scoring::paper_classifier) return " The paper has no such classifier.";
  if (!reference.beside()) return " The paper has no such data set.";
  return " What the paper publishes is from its Tables 6 to 11 (results/published/*.csv).";
}

std::string about_bar(const std::optional<AccuracyRow>& bar) {
  if (!bar) return "";
  return " " + report::bar_label(*bar) + " is " + diagnosis::the_classifier(bar->classifier).what +
         ".";
}

Table accuracies_of(const DatasetContents& contents, const report::ClassifierRows& block,
                    const report::PaperReference& reference) {
  Table table = table_by_ratio("Accuracy on " + contents.name +
                                   ", percent: mean ± standard deviation over seeds" + by(block),
                               block.rows, block.bar, [&](const AccuracyRow& row) {
                                 return accuracy_cell(row, reference, contents.grid.seeds.size());
                               });
  table.below = "A method’s numbers are the attribute accuracy of " + contents.name +
                "/seed*/<method>/<ratio>/" + block.classifier +
                "/diagnosis.h5; each is in the list of cells below." +
                about_published(reference, block.classifier) + about_bar(block.bar);
  return table;
}

Table gains_of(const DatasetContents& contents, const report::ClassifierRows& block,
               const report::PaperReference& reference) {
  Table table =
      table_by_ratio("Gain over none on " + contents.name +
                         ", points, with the 95 % interval of its mean" + by(block),
                     report::gain_rows(block.rows), std::nullopt, [&](const AccuracyRow& row) {
                       return gain_cell(row, reference, contents.grid.seeds.size());
                     });
  table.below =
      "▲ helps, ▼ harms, ○ makes no clear difference: whether the interval lies on one side of "
      "zero. Of fewer than three seeds there is none, and nothing follows. Seeds are paired, from "
      "the same artefacts as the accuracies.";
  return table;
}

/// The two tables of one classifier side by side.
Html tables_of(const DatasetContents& contents, const report::ClassifierRows& block) {
  const report::PaperReference reference(contents.name, block.classifier);
  const Table gains = gains_of(contents, block, reference);
  Html tables = element("div", html(accuracies_of(contents, block, reference)));
  if (!gains.rows.empty()) tables += element("div", html(gains));
  return element("div", {{"class", "pair"}}, tables);
}

}  // namespace

Html accuracy_view(const DatasetContents& contents) {
  const report::PaperReference reference(contents.name);
  Html view;
  for (const std::string& sentence : contents.verdict) {
    view += element("p", {{"class", "verdict"}}, sentence);
  }
  if (reference.beside() && !reference.beside()->own) {
    view += element("p", reference.beside()->caution);
  }
  if (contents.rows.empty()) return view + element("p", "No diagnosis is there yet.");
  for (const report::ClassifierRows& block : report::by_classifier(contents.rows)) {
    view += tables_of(contents, block);
  }
  return view;
}

}  // namespace piae::page
