#include "report/comparisons.hpp"

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/ratio_means.hpp"

namespace piae::report {

namespace {

/// Returns the method to compare with if the user requests none: a method of this project, else the
/// paper's, else "". Among several of this project it prefers the one made for such data sets: one
/// that carries faults to other conditions if `carry`, otherwise one that does not.
std::string method_of_interest(const std::vector<std::string>& methods, bool carry) {
  std::vector<std::string> ours;
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    const bool is_there = std::ranges::count(methods, entry.name) > 0;
    if (entry.kind != augment::Kind::ours || !is_there) continue;
    if (entry.carries == carry) return entry.name;
    ours.emplace_back(entry.name);
  }
  if (!ours.empty()) return ours.front();
  return std::ranges::count(methods, augment::paper_method()) > 0 ? augment::paper_method() : "";
}

std::string choose_other_side(const std::vector<AccuracyRow>& rows,
                              const std::vector<std::string>& methods,
                              const std::string& requested) {
  if (requested.empty()) return method_of_interest(methods, rows.front().speed_ratio.has_value());
  if (std::ranges::count(methods, requested) > 0) return requested;
  std::string known;
  for (const std::string& method : methods) known += ' ' + method;
  throw Error(Exit::usage,
              "--against " + requested + ": has no cell in this run; choose from:" + known);
}

/// Compares the means of the ratios that both have.
std::optional<PairedRow> paired_means(const std::vector<AccuracyRow>& rows,
                                      const std::vector<AccuracyRow>& others) {
  const auto mean_of = [](const std::vector<AccuracyRow>& own) {
    const bool is_baseline = own.size() == 1 && own.front().method == augment::no_method;
    return is_baseline ? std::optional(own.front()) : mean_row(own);
  };
  const auto mean = mean_of(cells_also_in(rows, others));
  const auto other = mean_of(cells_also_in(others, rows));
  return mean && other ? paired_row(*mean, *other) : std::nullopt;
}

/// Compares two methods at each ratio that both have, and in the mean.
std::vector<PairedRow> paired_rows_of(const std::vector<AccuracyRow>& rows,
                                      const std::string& method, const std::string& against) {
  std::vector<PairedRow> pairs;
  for (const RatioColumn& column : compared_columns(rows)) {
    const AccuracyRow* row = find_row(rows, method, column.ratio);
    const AccuracyRow* other = find_row(rows, against, column.ratio);
    if (row == nullptr || other == nullptr) continue;
    if (const auto pair = paired_row(*row, *other)) pairs.push_back(*pair);
  }
  if (const auto mean = paired_means(rows_of(rows, method), rows_of(rows, against))) {
    pairs.push_back(*mean);
  }
  return pairs;
}

}  // namespace

Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against) {
  const std::vector<std::string> methods = methods_of(rows);
  Comparisons comparisons{.dataset = rows.front().dataset,
                          .classifier = rows.front().classifier,
                          .against = choose_other_side(rows, methods, against)};
  if (comparisons.against.empty()) return comparisons;
  for (const std::string& method : methods) {
    if (method == comparisons.against) continue;
    std::ranges::move(paired_rows_of(rows, method, comparisons.against),
                      std::back_inserter(comparisons.rows));
  }
  add_holm_p(comparisons.rows);
  return comparisons;
}

std::vector<Comparisons> compare_by_classifier(const std::vector<AccuracyRow>& rows,
                                               const std::string& against) {
  const bool is_anywhere = std::ranges::count(methods_of(rows), against) > 0;
  std::vector<Comparisons> all;
  for (const ClassifierRows& block : by_classifier(rows)) {
    const bool is_here = std::ranges::count(methods_of(block.rows), against) > 0;
    if (is_here || !is_anywhere) all.push_back(compare_methods(block.rows, against));
  }
  return all;
}

std::string comparisons_csv(const std::vector<Comparisons>& comparisons) {
  struct Line {
    const Comparisons* of;
    const PairedRow* row;
  };
  std::vector<Line> lines;
  for (const Comparisons& each : comparisons) {
    for (const PairedRow& row : each.rows) lines.push_back({&each, &row});
  }
  Columns<Line> columns;
  columns.field("dataset", [](const Line& line) { return line.of->dataset; })
      .field("ratio", [](const Line& line) { return line.row->ratio; })
      .field("method", [](const Line& line) { return line.row->method; })
      .field("classifier", [](const Line& line) { return line.of->classifier; })
      .field("against", [](const Line& line) { return line.of->against; })
      .with(paired_columns(), [](const Line& line) { return *line.row; });
  return columns.table(lines).csv();
}

std::vector<Section> comparison_sections(const Comparisons& comparisons) {
  if (comparisons.rows.empty()) return {};
  return {PaperReference(comparisons.dataset, comparisons.classifier)
              .none()
              .of({.key = "comparisons",
                   .title = "Accuracy minus that of " + method_label(comparisons.against) + " on " +
                            comparisons.dataset,
                   .note = paired_note(comparisons.rows),
                   .table = paired_table(comparisons.rows)})};
}

}  // namespace piae::report
