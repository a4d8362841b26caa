#include "report/accuracy_table.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracy_columns.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/verdict.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<AccuracyRow>;

bool has_interval(const AccuracyRow& row) { return row.summary.interval.has_value(); }

/// Reader of a table with a row for each method and ratio.
enum class Writer { csv, terminal, documents };

/// Returns the heading of a column, empty if `writer` does not show it. `paper` is the heading of
/// published numbers.
std::string heading_of(const AccuracyColumn& column, Writer writer, const std::string& paper) {
  if (writer == Writer::csv) return column.field;
  if (writer == Writer::terminal) return column.terminal;
  return column.heading == std::string("paper") ? paper : column.heading;
}

bool is_informative(const text::Cell& cell) { return !cell.text.empty() && cell.text != no_number; }

text::Table rows_table(const std::vector<ShownRow>& rows, Writer writer, NumberStyle style = {},
                       const std::string& paper = "") {
  const bool types = std::ranges::any_of(
      rows, [](const ShownRow& shown) { return shown.row.type_accuracy.has_value(); });
  Columns<ShownRow> columns;
  if (writer == Writer::csv) {
    columns.name_fields(&ShownRow::row);
  } else {
    columns.words("method", &ShownRow::name).words("ratio", [](const ShownRow& shown) {
      return ratio_label(shown.row.ratio, shown.row.true_ratio);
    });
  }
  for (const AccuracyColumn& column : accuracy_columns()) {
    const std::string heading = heading_of(column, writer, paper);
    if (heading.empty() || column.types.value_or(types) != types) continue;
    const auto cell_of = [&column, style](const ShownRow& shown) {
      return column.cell(shown.row, style);
    };
    const bool any = std::ranges::any_of(
        rows, [&](const ShownRow& shown) { return is_informative(cell_of(shown)); });
    if (writer == Writer::csv) {
      columns.field(heading, cell_of);
    } else if (writer == Writer::terminal || any) {
      columns.numbers(heading, cell_of);
    }
  }
  return columns.table(rows);
}

/// True if any row of a method has fewer seeds than a row of another method.
bool has_fewer_seeds(const Rows& own, const Rows& all) {
  const auto count = [](const AccuracyRow& row) { return row.seeds.size(); };
  return count(*std::ranges::min_element(own, {}, count)) <
         count(*std::ranges::max_element(all, {}, count));
}

/// Returns "1, seed 0", or "6" if the paper has more runs than there are seeds.
std::string run_label(std::size_t run, const std::vector<std::int64_t>& seeds) {
  const std::string label = std::to_string(run + 1);
  return run < seeds.size() ? label + ", seed " + std::to_string(seeds[run]) : label;
}

std::string value_label(const std::vector<double>& percents, std::size_t run) {
  return run < percents.size() ? number_label(percents[run]) : "";
}

/// Returns the value of a row at the seed of a run, or "" if the row does not have the seed.
std::string value_of_seed(const AccuracyRow& row, const std::vector<std::int64_t>& seeds,
                          std::size_t run) {
  const auto value = run < seeds.size() ? row.at(seeds[run]) : std::nullopt;
  return value ? number_label(*value) : "";
}

/// Returns Table 6 with a run in each row, because ten columns would be too wide. `reference_row`
/// is null if unknown.
text::Table runs_table(const AccuracyRow& row, const AccuracyRow* reference_row,
                       const PaperReference& reference, const Published& published) {
  const std::optional<double> theirs = row.theirs();
  const std::vector<double> their_runs =
      theirs ? published.baseline_runs(reference.counterpart()->paper.name) : std::vector<double>{};
  Cells header{"run", "here"};
  if (reference_row != nullptr) header.push_back("by " + reference_row->classifier);
  if (theirs) header.push_back(reference.label());
  text::Table table(header, 1);
  for (std::size_t run = 0; run < std::max(row.values.size(), their_runs.size()); ++run) {
    Cells cells{run_label(run, row.seeds), value_label(row.values, run)};
    if (reference_row != nullptr) cells.push_back(value_of_seed(*reference_row, row.seeds, run));
    if (theirs) cells.push_back(value_label(their_runs, run));
    table.row(cells);
  }
  Cells mean{"mean", mean_label(row.summary)};
  if (reference_row != nullptr) mean.push_back(mean_label(reference_row->summary));
  if (theirs) mean.push_back(number_label(*theirs));
  table.row(mean);
  if (has_interval(row)) {
    Cells interval{"95 % interval", interval_label(row.summary)};
    if (reference_row != nullptr) interval.push_back(interval_label(reference_row->summary));
    table.row(interval);
  }
  return table;
}

void add_line(text::Table& table, const std::string& name, const Rows& own,
              const std::vector<RatioColumn>& columns, const MatrixStyle& style) {
  text::Cells cells{name};
  for (const RatioColumn& column : columns) {
    const auto row = std::ranges::find(own, column.ratio, &AccuracyRow::ratio);
    cells.push_back(row == own.end() ? text::Cell() : style.cell_of(*row));
  }
  table.row(std::move(cells), looks_of(own.front().method));
}

/// Returns "Model 2", or "outlook" if the paper has no number for the model.
std::string model_name(const augment::CatalogueEntry& model) {
  return model.model > 0 ? "Model " + std::to_string(model.model) : "outlook";
}

/// Returns "ae (Model 2)", the name of a method in a table of the models.
std::string model_label(const std::string& method) {
  return method + " (" + model_name(*augment::find_entry(method)) + ")";
}

/// Returns a block for each method, with a row for each ratio. `reference_row` is null if it is
/// unknown or not part of the table.
text::Table blocks_table(const MethodGroup& group, const Rows& rows,
                         const AccuracyRow* reference_row, const PaperReference& reference,
                         NumberStyle style) {
  std::vector<ShownRow> shown;
  const auto add_block = [&](const std::string& name, const Rows& own) {
    for (const AccuracyRow& row : own) {
      shown.push_back({shown.empty() || &row == own.data() ? name : "", row});
    }
  };
  for (const std::string& method : group.methods) {
    const Rows own = rows_of(rows, method);
    if (own.empty()) continue;
    add_block(marked_if(has_fewer_seeds(own, rows),
                        group.are_models ? model_label(method) : method_label(method)),
              own);
  }
  if (reference_row != nullptr) {
    add_block(marked_if(has_fewer_seeds({*reference_row}, rows), reference_label(*reference_row)),
              {*reference_row});
  }
  return rows_table(shown, Writer::documents, style, reference.label());
}

std::string about_reference(const std::optional<AccuracyRow>& reference_row) {
  return reference_row ? reference_label(*reference_row) + " is " +
                             diagnosis::the_classifier(reference_row->classifier).what
                       : "";
}

std::string means_note(const PaperReference& reference,
                       const std::optional<AccuracyRow>& reference_row) {
  const std::string of_reference = reference_row
                                       ? " " + about_reference(reference_row) +
                                             ": a method that does not exceed it is not needed."
                                       : "";
  return std::string("All methods side by side. Spread and intervals") +
         (reference.counterpart() ? ", and the published values," : "") +
         " follow for each method." + of_reference;
}

constexpr const char* types_note =
    "How often the fault type is correct (healthy, or the damaged part of the bearing), whatever "
    "the size of the defect.";

constexpr const char* gain_note =
    "Accuracy minus that of the same seed without generated windows; mean and spread are those of "
    "the differences. The published gains are differences of the published tables.";

std::string models_note(const MethodGroup& group) {
  std::string note;
  if (!group.are_models) return note;
  for (const std::string& method : group.methods) {
    const augment::CatalogueEntry& model = *augment::find_entry(method);
    note += (note.empty() ? "" : "; ") + model_name(model) + ": " + std::string(model.name) + ", " +
            model.what;
  }
  return note + ".";
}

void add_group(std::vector<Section>& sections, const MethodGroup& group,
               const ClassifierRows& of_classifier, const Rows& gains,
               const PaperReference& reference) {
  const auto& [classifier, rows, reference_row] = of_classifier;
  sections.push_back(
      reference.table(group.table)
          .of({"accuracy-" + group.key,
               "Accuracy of " + group.name + " on " + reference.dataset() + ", percent",
               models_note(group),
               blocks_table(group, rows, reference_row ? &*reference_row : nullptr, reference,
                            {})}));
  if (gains.empty()) return;
  sections.push_back(
      reference.figure(group.gain_figure)
          .of({"gain-" + group.key,
               "Gain of " + group.name + " over none on " + reference.dataset() + ", points",
               gain_note, blocks_table(group, gains, nullptr, reference, {.sign = true})}));
}

/// Returns the artefacts that a mean was computed from.
std::string files_of(const AccuracyRow& row) {
  return fmt::format("{}/seed{{{}}}/{}/{}/{}/diagnosis.h5, attribute accuracy", row.dataset,
                     fmt::join(row.seeds, ","), row.method, row.ratio, row.classifier);
}

/// Returns the mean, with all other columns that are not empty below it.
text::Cell page_cell(const AccuracyRow& row, NumberStyle style, const PaperReference& reference,
                     std::size_t seeds) {
  text::Cell cell = mean_cell(row.summary, style);
  cell.source = files_of(row);
  for (const AccuracyColumn& column : accuracy_columns()) {
    const std::string heading = heading_of(column, Writer::documents, reference.label());
    if (heading.empty() ||
        column.types.value_or(row.type_accuracy.has_value()) != row.type_accuracy.has_value() ||
        column.field == std::string("mean")) {
      continue;
    }
    const text::Cell other = column.cell(row, style);
    cell.more.push_back(is_informative(other) ? heading + " " + other.text : "");
  }
  cell.more.push_back(
      row.seeds.size() < seeds ? fmt::format("{} of {} seeds", row.seeds.size(), seeds) : "");
  return cell;
}

/// Adds a sign to the text, so that the effect does not depend on colour.
text::Cell with_effect(text::Cell cell, Effect effect) {
  constexpr std::array signs{"▲ ", "○ ", "▼ "};
  constexpr std::array looks{"helps", "unclear", "harms"};
  cell.text = signs.at(static_cast<std::size_t>(effect)) + cell.text;
  cell.looks = looks.at(static_cast<std::size_t>(effect));
  return cell;
}

/// Returns the classifier for the end of a table's title, or "" for the paper's classifier.
std::string by(const ClassifierRows& block) {
  return block.classifier == scoring::paper_classifier
             ? ""
             : ", by " + diagnosis::marked_name(block.classifier);
}

std::string about_published(const PaperReference& reference, const std::string& classifier) {
  if (classifier != scoring::paper_classifier) return " The paper does not use this classifier.";
  if (!reference.counterpart()) return " The paper does not use this data set.";
  return " Published values are from Tables 6 to 11 of the paper (results/published/*.csv).";
}

constexpr const char* about_signs =
    "▲ helps (interval above zero), ▼ harms (below zero), ○ makes no clear difference. Fewer than "
    "three seeds have no interval and allow no conclusion. Seeds are paired, from the same "
    "artefacts as the accuracies.";

}  // namespace

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  std::vector<ShownRow> all;
  for (const AccuracyRow& row : rows) all.push_back({row.method, row});
  return rows_table(all, Writer::csv).csv();
}

std::string accuracy_text(const std::vector<AccuracyRow>& rows) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  std::string text;
  for (const ClassifierRows& block : blocks) {
    std::vector<ShownRow> shown;
    for (const AccuracyRow& row : block.rows) shown.push_back({method_label(row.method), row});
    if (block.reference_row)
      shown.push_back({reference_label(*block.reference_row), *block.reference_row});
    if (blocks.size() > 1) text += "by " + diagnosis::marked_name(block.classifier) + '\n';
    text += rows_table(shown, Writer::terminal).plain();
  }
  return text;
}

text::Table ratio_matrix(const std::vector<AccuracyRow>& rows,
                         const std::optional<AccuracyRow>& reference_row,
                         const MatrixStyle& style) {
  Rows all = rows;
  if (reference_row) all.push_back(*reference_row);
  const std::vector<RatioColumn> columns = ratio_columns(all);
  text::Table table({"method"}, 1);
  for (const RatioColumn& column : columns) {
    table.column({.heading = style.short_ratios ? short_ratio_label(column.ratio) : column.label,
                  .is_number = true});
  }
  const auto add = [&](const std::string& name, const Rows& own) {
    const bool marked = style.marks_fewer_seeds && has_fewer_seeds(own, rows);
    add_line(table, marked_if(marked, name), own, columns, style);
  };
  for (const std::string& method : methods_of(rows))
    add(method_label(method), rows_of(rows, method));
  if (reference_row) add(reference_label(*reference_row), {*reference_row});
  return table;
}

std::vector<Section> ratio_sections(const ClassifierRows& block, std::size_t seeds) {
  const std::string& dataset = block.rows.front().dataset;
  const PaperReference reference(dataset, block.classifier);
  std::vector<Section> sections{
      {.key = "accuracy",
       .title =
           "Accuracy on " + dataset + ", percent: mean ± standard deviation over seeds" + by(block),
       .note = "A method’s numbers are the attribute accuracy of " + dataset +
               "/seed*/<method>/<ratio>/" + block.classifier +
               "/diagnosis.h5; each is in the list of cells below." +
               about_published(reference, block.classifier) +
               (block.reference_row ? " " + about_reference(block.reference_row) + "." : ""),
       .table =
           ratio_matrix(block.rows, block.reference_row, {.cell_of = [&](const AccuracyRow& row) {
                          return page_cell(row, {}, reference, seeds);
                        }})}};
  const Rows gains = gain_rows(block.rows);
  if (gains.empty()) return sections;
  sections.push_back({.key = "gain",
                      .title = "Gain over none on " + dataset +
                               ", points, with the 95 % interval of its mean" + by(block),
                      .note = about_signs,
                      .table = ratio_matrix(gains, {}, {.cell_of = [&](const AccuracyRow& row) {
                                              text::Cell cell =
                                                  page_cell(row, {.sign = true}, reference, seeds);
                                              cell.source += ", minus that of none";
                                              return with_effect(std::move(cell), effect_of(row));
                                            }})});
  return sections;
}

std::vector<Section> accuracy_sections(const ClassifierRows& of_classifier,
                                       const Published& published) {
  const Rows& rows = of_classifier.rows;
  const std::optional<AccuracyRow>& reference_row = of_classifier.reference_row;
  const std::string& dataset = rows.front().dataset;
  const PaperReference reference(dataset, of_classifier.classifier);
  const Rows gains = gain_rows(rows);
  std::vector<std::string> methods = methods_of(rows);
  const auto means_of = [&](const scoring::Summary& (*shown)(const AccuracyRow&)) {
    return ratio_matrix(rows, reference_row,
                        {.marks_fewer_seeds = true, .cell_of = [&](const AccuracyRow& row) {
                           return number_cell(shown(row).mean);
                         }});
  };
  std::vector<Section> sections;
  if (methods.size() > 1) {
    sections.push_back(reference.none().of(
        {"accuracy-means", "Mean accuracy on " + dataset + ", percent",
         means_note(reference, reference_row),
         means_of([](const AccuracyRow& row) -> const scoring::Summary& { return row.summary; })}));
  }
  if (have_fault_types(rows)) {
    sections.push_back(reference.none().of(
        {"accuracy-kinds", "Mean accuracy by fault type on " + dataset + ", percent", types_note,
         means_of([](const AccuracyRow& row) -> const scoring::Summary& {
           return *row.type_accuracy;
         })}));
  }
  for (const AccuracyRow& row : rows_of(rows, augment::no_method)) {
    sections.push_back(reference.table(&PaperDataset::baseline_table)
                           .of({"accuracy-none",
                                "Accuracy on " + dataset + " without generated windows, " +
                                    ratio_label(row.ratio, row.true_ratio) + ", percent",
                                "",
                                runs_table(row, reference_row ? &*reference_row : nullptr,
                                           reference, published)}));
  }
  std::erase(methods, augment::no_method);
  for (const MethodGroup& group : method_groups(methods)) {
    add_group(sections, group, of_classifier, gains, reference);
  }
  return sections;
}

}  // namespace piae::report
