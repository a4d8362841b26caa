#include "page/accuracy_view.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "page/table.hpp"
#include "page/words.hpp"
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
  return fmt::format("{}/seed{{{}}}/{}/{}/diagnosis.h5, attribute accuracy", row.dataset,
                     fmt::join(row.seeds, ","), row.method, row.ratio);
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

Sign sign_of(report::Effect effect) {
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
  const Sign sign = sign_of(report::effect_of(row));
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

/// A method in each row, a ratio in each column.
template <class CellOf>
Table table_by_ratio(const std::string& caption, const std::vector<AccuracyRow>& rows,
                     const CellOf& cell_of) {
  Table table{.caption = caption, .columns = {{"method"}}};
  const std::vector<report::RatioColumn> columns = report::ratio_columns(rows);
  for (const report::RatioColumn& column : columns) table.columns.push_back({column.label, true});
  for (const std::string& method : report::methods_of(rows)) {
    Row line{.cells = {{.content = report::method_label(method)}},
             .looks = augment::is_ceiling(method) ? "ceiling" : ""};
    for (const report::RatioColumn& column : columns) {
      const auto row = std::ranges::find_if(rows, [&](const AccuracyRow& each) {
        return each.method == method && each.ratio == column.ratio;
      });
      line.cells.push_back(row == rows.end() ? Cell{} : cell_of(*row));
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

std::string about_published(const report::PaperReference& reference) {
  if (!reference.beside()) return " The paper has no such data set.";
  return " What the paper publishes is from its Tables 6 to 11 (results/published/*.csv).";
}

Table accuracies_of(const DatasetContents& contents, const report::PaperReference& reference) {
  Table table = table_by_ratio(
      "Accuracy on " + contents.name + ", percent: mean ± standard deviation over seeds",
      contents.rows, [&](const AccuracyRow& row) {
        return accuracy_cell(row, reference, contents.grid.seeds.size());
      });
  table.below = "A method’s numbers are the attribute accuracy of " + contents.name +
                "/seed*/<method>/<ratio>/diagnosis.h5; each is in the list of cells below." +
                about_published(reference);
  return table;
}

Table gains_of(const DatasetContents& contents, const report::PaperReference& reference) {
  Table table = table_by_ratio(
      "Gain over none on " + contents.name + ", points, with the 95 % interval of its mean",
      contents.gains, [&](const AccuracyRow& row) {
        return gain_cell(row, reference, contents.grid.seeds.size());
      });
  table.below =
      "▲ helps, ▼ harms, ○ makes no clear difference: whether the interval lies on one side of "
      "zero. Of fewer than three seeds there is none, and nothing follows. Seeds are paired, from "
      "the same artefacts as the accuracies.";
  return table;
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
  Html tables = element("div", html(accuracies_of(contents, reference)));
  if (!contents.gains.empty()) tables += element("div", html(gains_of(contents, reference)));
  return view + element("div", {{"class", "pair"}}, tables);
}

}  // namespace piae::page
