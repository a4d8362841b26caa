#include "report/accuracy_sections.hpp"

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"
#include "report/paper_methods.hpp"
#include "report/paper_reference.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<AccuracyRow>;

std::optional<double> shown_of_paper(const AccuracyRow& row) {
  return row.published ? row.published : row.orientation;
}

Cells runs_row(const std::string& name, const std::vector<double>& percents, std::size_t runs) {
  Cells cells{name};
  for (const double percent : percents) cells.push_back(number_label(percent));
  cells.resize(runs + 1);
  return cells;
}

std::string seeds_label(const std::vector<std::int64_t>& seeds) {
  std::string label = seeds.size() == 1 ? "here, seed" : "here, seeds";
  for (const std::int64_t seed : seeds) label += " " + std::to_string(seed);
  return label;
}

/// As Table 6: a run in each column, ours above the paper's.
text::Table runs_table(const run::Grid& grid, const AccuracyRow& row,
                       const PaperReference& reference, const Published& published) {
  const std::vector<double> theirs = reference.beside()
                                         ? published.baseline_runs(reference.beside()->paper.name)
                                         : std::vector<double>{};
  const std::size_t runs = std::max(row.values.size(), theirs.size());
  Cells header{""};
  for (std::size_t i = 0; i < runs; ++i) header.push_back("run " + std::to_string(i + 1));
  header.insert(header.end(), {"mean", "95 % interval"});
  text::Table table(header, 1);
  Cells ours = runs_row(seeds_label(grid.seeds), row.values, runs);
  ours.insert(ours.end(), {mean_label(row.summary), interval_label(row.summary)});
  table.row(ours);
  if (const auto percent = shown_of_paper(row)) {
    Cells paper = runs_row(reference.label(), theirs, runs);
    paper.push_back(number_label(*percent));
    table.row(paper);
  }
  return table;
}

/// "ae (Model 2)": how a table of the models names a method.
std::string model_label(const std::string& method) {
  return method + " (Model " + std::to_string(augment::find_entry(method)->model) + ")";
}

void add_method(text::Table& table, const std::string& label, const std::vector<AccuracyRow>& rows,
                const PaperReference& reference, NumberStyle style) {
  Cells ours{label, "here"};
  Cells intervals{"", "95 %"};
  Cells paper{"", reference.label()};
  for (const AccuracyRow& row : rows) {
    const auto theirs = shown_of_paper(row);
    ours.push_back(mean_label(row.summary, style));
    intervals.push_back(interval_label(row.summary, style));
    paper.push_back(theirs ? number_label(*theirs, style) : "");
  }
  const auto has_interval = [](const AccuracyRow& row) { return row.summary.interval.has_value(); };
  const auto is_in_paper = [](const AccuracyRow& row) { return shown_of_paper(row).has_value(); };
  table.row(ours);
  if (std::ranges::any_of(rows, has_interval)) table.row(intervals);
  if (std::ranges::any_of(rows, is_in_paper)) table.row(paper);
}

/// As Table 8: a ratio in each column, up to three lines for each method. All methods of a grid
/// have the same ratios.
text::Table ratios_table(const std::vector<std::string>& methods, bool as_models, const Rows& rows,
                         const PaperReference& reference, NumberStyle style) {
  Cells header{"method", ""};
  for (const AccuracyRow& row : rows_of(rows, methods.front())) {
    header.push_back(ratio_label(row.ratio, row.true_ratio));
  }
  text::Table table(header, 2);
  for (const std::string& method : methods) {
    add_method(table, as_models ? model_label(method) : method_label(method), rows_of(rows, method),
               reference, style);
  }
  return table;
}

constexpr const char* gain_note =
    "Accuracy minus that of the same seed without generated windows; mean and spread are those of "
    "the differences. The published gains are differences of the published tables.";

std::string models_note(const MethodGroup& group) {
  std::string note;
  if (!group.are_models) return note;
  for (const std::string& method : group.methods) {
    const augment::CatalogueEntry& model = *augment::find_entry(method);
    note += (note.empty() ? "Model " : "; Model ") + std::to_string(model.model) + ": " +
            std::string(model.name) + ", " + model.what;
  }
  return note + ".";
}

void add_group(std::vector<Section>& sections, const MethodGroup& group, const Rows& rows,
               const Rows& gains, const PaperReference& reference) {
  const auto table = [&](const Rows& of, NumberStyle style) {
    return ratios_table(group.methods, group.are_models, of, reference, style);
  };
  sections.push_back({"accuracy-" + group.key,
                      "Accuracy of " + group.name + " on " + reference.dataset() + ", percent" +
                          reference.table(group.table),
                      models_note(group), table(rows, {})});
  if (gains.empty()) return;
  sections.push_back({"gain-" + group.key,
                      "Gain of " + group.name + " over none on " + reference.dataset() +
                          ", points" + reference.figure(group.gain_figure),
                      gain_note, table(gains, {.sign = true})});
}

}  // namespace

std::vector<Section> accuracy_sections(const run::Grid& grid, const std::vector<AccuracyRow>& rows,
                                       const Published& published) {
  const PaperReference reference(grid.dataset);
  const Rows gains = gain_rows(rows);
  std::vector<Section> sections;
  for (const AccuracyRow& row : rows_of(rows, augment::no_method)) {
    sections.push_back({"accuracy-none",
                        "Accuracy on " + grid.dataset + " without generated windows, " +
                            ratio_label(row.ratio, row.true_ratio) + ", percent" +
                            reference.table(&PaperDataset::baseline_table),
                        "", runs_table(grid, row, reference, published)});
  }
  std::vector<std::string> methods = methods_of(rows);
  std::erase(methods, augment::no_method);
  for (const MethodGroup& group : method_groups(methods)) {
    add_group(sections, group, rows, gains, reference);
  }
  return sections;
}

}  // namespace piae::report
