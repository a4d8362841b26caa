#include "report/accuracy_sections.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/labels.hpp"
#include "report/paper_methods.hpp"
#include "report/paper_reference.hpp"
#include "report/ratio_columns.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;
using Rows = std::vector<AccuracyRow>;

std::optional<double> shown_of_paper(const AccuracyRow& row) {
  return row.published ? row.published : row.orientation;
}

bool has_interval(const AccuracyRow& row) { return row.summary.interval.has_value(); }
bool is_in_paper(const AccuracyRow& row) { return shown_of_paper(row).has_value(); }

/// Whether any of a method's rows has fewer seeds than rows of others have.
bool has_fewer_seeds(const Rows& own, const Rows& all) {
  const auto count = [](const AccuracyRow& row) { return row.seeds.size(); };
  return count(*std::ranges::min_element(own, {}, count)) <
         count(*std::ranges::max_element(all, {}, count));
}

/// "1, seed 0"; where the paper has more runs than there are seeds, "6".
std::string run_label(std::size_t run, const std::vector<std::int64_t>& seeds) {
  const std::string label = std::to_string(run + 1);
  return run < seeds.size() ? label + ", seed " + std::to_string(seeds[run]) : label;
}

std::string value_label(const std::vector<double>& percents, std::size_t run) {
  return run < percents.size() ? number_label(percents[run]) : "";
}

/// What a row has at the seed of a run; empty where it does not have it.
std::string value_of_seed(const AccuracyRow& row, const std::vector<std::int64_t>& seeds,
                          std::size_t run) {
  const auto value = run < seeds.size() ? row.at(seeds[run]) : std::nullopt;
  return value ? number_label(*value) : "";
}

/// As Table 6, but with a run in each row: ten would be too wide. `bar` is null where it is
/// unknown.
text::Table runs_table(const AccuracyRow& row, const AccuracyRow* bar,
                       const PaperReference& reference, const Published& published) {
  const std::optional<double> theirs = shown_of_paper(row);
  const std::vector<double> their_runs =
      theirs ? published.baseline_runs(reference.beside()->paper.name) : std::vector<double>{};
  Cells header{"run", "here"};
  if (bar != nullptr) header.push_back("by " + bar->classifier);
  if (theirs) header.push_back(reference.label());
  text::Table table(header, 1);
  for (std::size_t run = 0; run < std::max(row.values.size(), their_runs.size()); ++run) {
    Cells cells{run_label(run, row.seeds), value_label(row.values, run)};
    if (bar != nullptr) cells.push_back(value_of_seed(*bar, row.seeds, run));
    if (theirs) cells.push_back(value_label(their_runs, run));
    table.row(cells);
  }
  Cells mean{"mean", mean_label(row.summary)};
  if (bar != nullptr) mean.push_back(mean_label(bar->summary));
  if (theirs) mean.push_back(number_label(*theirs));
  table.row(mean);
  if (has_interval(row)) {
    Cells interval{"95 % interval", interval_label(row.summary)};
    if (bar != nullptr) interval.push_back(interval_label(bar->summary));
    table.row(interval);
  }
  return table;
}

/// What of a row a table of means shows: its accuracy, or that by kind of defect.
using Shown = const scoring::Summary& (*)(const AccuracyRow&);
const scoring::Summary& by_class(const AccuracyRow& row) { return row.summary; }
const scoring::Summary& kind_summary(const AccuracyRow& row) { return *row.kind; }

void add_means(text::Table& table, const std::string& name, const Rows& own,
               const std::vector<RatioColumn>& columns, Shown shown) {
  Cells cells{name};
  for (const RatioColumn& column : columns) {
    const auto row = std::ranges::find(own, column.ratio, &AccuracyRow::ratio);
    cells.push_back(row == own.end() ? "" : number_label(shown(*row).mean));
  }
  table.row(cells);
}

/// The means alone: a method in each row, a ratio in each column.
text::Table means_table(const Rows& rows, const std::optional<AccuracyRow>& bar, Shown shown) {
  Rows all = rows;
  if (bar) all.push_back(*bar);
  const std::vector<RatioColumn> columns = ratio_columns(all);
  Cells header{"method"};
  for (const RatioColumn& column : columns) header.push_back(column.label);
  text::Table table(header, 1);
  for (const std::string& method : methods_of(rows)) {
    const Rows own = rows_of(rows, method);
    add_means(table, marked_if(has_fewer_seeds(own, rows), method_label(method)), own, columns,
              shown);
  }
  if (bar) {
    add_means(table, marked_if(has_fewer_seeds({*bar}, rows), bar_label(*bar)), {*bar}, columns,
              shown);
  }
  return table;
}

/// "Model 2"; "outlook" where the paper has no number for it.
std::string model_name(const augment::CatalogueEntry& model) {
  return model.model > 0 ? "Model " + std::to_string(model.model) : "outlook";
}

/// "ae (Model 2)": how a table of the models names a method.
std::string model_label(const std::string& method) {
  return method + " (" + model_name(*augment::find_entry(method)) + ")";
}

/// A block for each method, and in it a row for each ratio. Columns that would be empty are left
/// out. `bar` is null where it is unknown, or no part of the table.
text::Table blocks_table(const MethodGroup& group, const Rows& rows, const AccuracyRow* bar,
                         const PaperReference& reference, NumberStyle style) {
  const auto any = [&](bool (*holds)(const AccuracyRow&)) {
    return std::ranges::any_of(rows, [&](const AccuracyRow& row) {
      return holds(row) && std::ranges::count(group.methods, row.method) > 0;
    });
  };
  const bool intervals = any(has_interval);
  const bool paper = any(is_in_paper);
  const bool kinds = tell_kinds(rows);
  Cells header{"method", "ratio", "here"};
  if (intervals) header.emplace_back("95 % interval");
  if (kinds) header.emplace_back("kind of defect");
  if (paper) header.push_back(reference.label());
  text::Table table(header, 2);
  const auto add_block = [&](std::string name, const Rows& own) {
    for (const AccuracyRow& row : own) {
      const std::optional<double> theirs = shown_of_paper(row);
      Cells cells{name, ratio_label(row.ratio, row.true_ratio), mean_label(row.summary, style)};
      if (intervals) cells.push_back(interval_label(row.summary, style));
      if (kinds) cells.push_back(mean_label(*row.kind, style));
      if (paper) cells.push_back(theirs ? number_label(*theirs, style) : "");
      table.row(cells);
      name.clear();
    }
  };
  for (const std::string& method : group.methods) {
    const Rows own = rows_of(rows, method);
    if (own.empty()) continue;
    add_block(marked_if(has_fewer_seeds(own, rows),
                        group.are_models ? model_label(method) : method_label(method)),
              own);
  }
  if (bar != nullptr) {
    add_block(marked_if(has_fewer_seeds({*bar}, rows), bar_label(*bar)), {*bar});
  }
  return table;
}

std::string means_note(const PaperReference& reference, const std::optional<AccuracyRow>& bar) {
  const std::string of_bar = bar ? " " + bar_label(*bar) + " is " +
                                       diagnosis::the_classifier(bar->classifier).what +
                                       ": what a method must exceed to be needed."
                                 : "";
  return std::string("All methods side by side. Their spread and intervals") +
         (reference.beside() ? ", and what the paper publishes," : "") +
         " follow, method by method." + of_bar;
}

constexpr const char* kinds_note =
    "How often the kind is right: healthy, or which part of the bearing is damaged, whatever the "
    "size. It is what a maintainer asks first.";

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
  const auto& [classifier, rows, bar] = of_classifier;
  sections.push_back(
      reference.table(group.table)
          .of({"accuracy-" + group.key,
               "Accuracy of " + group.name + " on " + reference.dataset() + ", percent",
               models_note(group),
               blocks_table(group, rows, bar ? &*bar : nullptr, reference, {})}));
  if (gains.empty()) return;
  sections.push_back(
      reference.figure(group.gain_figure)
          .of({"gain-" + group.key,
               "Gain of " + group.name + " over none on " + reference.dataset() + ", points",
               gain_note, blocks_table(group, gains, nullptr, reference, {.sign = true})}));
}

}  // namespace

std::vector<Section> accuracy_sections(const ClassifierRows& of_classifier,
                                       const Published& published) {
  const auto& [classifier, rows, bar] = of_classifier;
  const std::string& dataset = rows.front().dataset;
  const PaperReference reference(dataset, classifier);
  const Rows gains = gain_rows(rows);
  std::vector<std::string> methods = methods_of(rows);
  std::vector<Section> sections;
  if (methods.size() > 1) {
    sections.push_back(
        reference.none().of({"accuracy-means", "Mean accuracy on " + dataset + ", percent",
                             means_note(reference, bar), means_table(rows, bar, by_class)}));
  }
  if (tell_kinds(rows)) {
    sections.push_back(reference.none().of(
        {"accuracy-kinds", "Mean accuracy by kind of defect on " + dataset + ", percent",
         kinds_note, means_table(rows, bar, kind_summary)}));
  }
  for (const AccuracyRow& row : rows_of(rows, augment::no_method)) {
    sections.push_back(reference.table(&PaperDataset::baseline_table)
                           .of({"accuracy-none",
                                "Accuracy on " + dataset + " without generated windows, " +
                                    ratio_label(row.ratio, row.true_ratio) + ", percent",
                                "", runs_table(row, bar ? &*bar : nullptr, reference, published)}));
  }
  std::erase(methods, augment::no_method);
  for (const MethodGroup& group : method_groups(methods)) {
    add_group(sections, group, of_classifier, gains, reference);
  }
  return sections;
}

}  // namespace piae::report
