#include "report/accuracies.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

void add_published(AccuracyRow& row, const Published& published) {
  if (row.classifier != scoring::paper_classifier) return;
  const std::optional<Counterpart> counterpart = PaperReference(row.dataset).counterpart();
  if (!counterpart) return;
  const auto percent = published.percent(counterpart->paper.name, row.method, row.ratio);
  (counterpart->own ? row.published : row.orientation) = percent;
}

std::optional<double> difference(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a - *b) : std::nullopt;
}

/// Returns a row without values if the rows have no seed in common.
AccuracyRow gain_of(AccuracyRow row, const AccuracyRow& baseline) {
  const Pairs pairs = pairs_of(row, baseline);
  row.seeds = pairs.seeds;
  row.values.resize(pairs.seeds.size());
  std::ranges::transform(pairs.first, pairs.second, row.values.begin(), std::minus());
  if (row.values.empty()) return row;
  row.summary = summarise_within(differences_of_percents, row.values);
  row.type_accuracy.reset();
  row.published = difference(row.published, baseline.published);
  row.orientation = difference(row.orientation, baseline.orientation);
  return row;
}

bool is_reference(const AccuracyRow& row) {
  return row.method == augment::no_method && row.classifier == diagnosis::reference_classifier;
}

}  // namespace

void bound(scoring::Summary& summary, const Bounds& bounds) {
  constexpr std::size_t fewest_for_an_interval = 3;
  if (summary.count < fewest_for_an_interval) {
    summary.interval.reset();
  } else {
    summary.interval->low = std::max(summary.interval->low, bounds.low);
    summary.interval->high = std::min(summary.interval->high, bounds.high);
  }
}

scoring::Summary summarise_within(const Bounds& bounds, std::span<const double> values) {
  scoring::Summary summary = scoring::summarise(values);
  bound(summary, bounds);
  return summary;
}

AccuracyRow accuracy_row(const std::string& dataset, const std::vector<run::Diagnosis>& cells) {
  const run::Diagnosis& first = cells.front();
  AccuracyRow row;
  row.dataset = dataset;
  row.method = first.method;
  row.classifier = first.classifier;
  row.ratio = first.ratio;
  row.generated_per_class = first.generated_per_class;
  row.true_ratio = first.true_ratio;
  row.speed_ratio = first.speed_ratio;
  std::vector<double> types;
  for (const run::Diagnosis& cell : cells) {
    row.seeds.push_back(cell.seed);
    row.values.push_back(100 * cell.accuracy);
    if (cell.type_accuracy) types.push_back(100 * *cell.type_accuracy);
  }
  row.summary = summarise_within(percents, row.values);
  if (!types.empty()) row.type_accuracy = summarise_within(percents, types);
  return row;
}

std::vector<AccuracyRow> accuracy_rows(const run::Grid& grid, const run::Results& results,
                                       const Published& published) {
  std::vector<AccuracyRow> rows;
  for (const run::Combination& combination : grid.combinations) {
    const std::vector<run::Diagnosis> cells = run::diagnoses_of(results, combination);
    if (cells.empty()) continue;
    rows.push_back(accuracy_row(grid.dataset, cells));
    add_published(rows.back(), published);
  }
  return rows;
}

std::optional<double> AccuracyRow::at(std::int64_t seed) const {
  const auto found = std::ranges::find(seeds, seed);
  return found == seeds.end() ? std::nullopt : std::optional(values[found - seeds.begin()]);
}

Pairs pairs_of(const AccuracyRow& first, const AccuracyRow& second) {
  Pairs pairs;
  for (std::size_t i = 0; i < first.seeds.size(); ++i) {
    const std::optional<double> other = second.at(first.seeds[i]);
    if (!other) continue;
    pairs.seeds.push_back(first.seeds[i]);
    pairs.first.push_back(first.values[i]);
    pairs.second.push_back(*other);
  }
  return pairs;
}

std::vector<std::string> methods_of(const std::vector<AccuracyRow>& rows) {
  std::vector<std::string> methods;
  for (const AccuracyRow& row : rows) {
    if (std::ranges::count(methods, row.method) == 0) methods.push_back(row.method);
  }
  return methods;
}

bool have_fault_types(const std::vector<AccuracyRow>& rows) {
  return std::ranges::any_of(rows,
                             [](const AccuracyRow& row) { return row.type_accuracy.has_value(); });
}

std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method) {
  std::vector<AccuracyRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own),
                       [&](const AccuracyRow& row) { return row.method == method; });
  return own;
}

std::vector<std::int64_t> seeds_of_any(const std::vector<AccuracyRow>& rows) {
  std::set<std::int64_t> seeds;
  for (const AccuracyRow& row : rows) seeds.insert(row.seeds.begin(), row.seeds.end());
  return {seeds.begin(), seeds.end()};
}

std::vector<AccuracyRow> gain_rows(const std::vector<AccuracyRow>& rows) {
  std::vector<AccuracyRow> gains;
  for (const AccuracyRow& row : rows) {
    const auto baseline = std::ranges::find_if(rows, [&](const AccuracyRow& each) {
      return each.method == augment::no_method && each.classifier == row.classifier;
    });
    if (row.method == augment::no_method || baseline == rows.end()) continue;
    AccuracyRow gain = gain_of(row, *baseline);
    if (!gain.values.empty()) gains.push_back(std::move(gain));
  }
  return gains;
}

std::vector<ClassifierRows> by_classifier(const std::vector<AccuracyRow>& rows) {
  const auto reference_row = std::ranges::find_if(rows, is_reference);
  std::vector<ClassifierRows> blocks;
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    ClassifierRows block{.classifier = classifier.name, .rows = rows_by(rows, classifier.name)};
    const bool is_of_reference = std::ranges::any_of(block.rows, is_reference);
    const bool has_company = is_of_reference && block.rows.size() == 1 && !blocks.empty();
    if (block.rows.empty() || has_company) continue;
    if (reference_row != rows.end() && !is_of_reference) block.reference_row = *reference_row;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<AccuracyRow> rows_by(const std::vector<AccuracyRow>& rows,
                                 const std::string& classifier) {
  std::vector<AccuracyRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own),
                       [&](const AccuracyRow& row) { return row.classifier == classifier; });
  return own;
}

std::string reference_label(const AccuracyRow& reference_row) {
  return run::name_by(reference_row.method, reference_row.classifier);
}

std::vector<ShownRow> rows_with_most_windows(const ClassifierRows& block) {
  std::vector<ShownRow> shown;
  for (const std::string& method : methods_of(block.rows)) {
    const std::vector<AccuracyRow> own = rows_of(block.rows, method);
    shown.push_back({method_label(method),
                     *std::ranges::max_element(own, {}, &AccuracyRow::generated_per_class)});
  }
  if (block.reference_row)
    shown.push_back({reference_label(*block.reference_row), *block.reference_row});
  return shown;
}

std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows) {
  std::vector<RatioColumn> columns;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const auto row = std::ranges::find(rows, ratio.name, &AccuracyRow::ratio);
    if (row != rows.end()) {
      columns.push_back({ratio.name, ratio_label(row->ratio, row->true_ratio)});
    }
  }
  return columns;
}

std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows) {
  std::vector<RatioColumn> columns = ratio_columns(rows);
  std::erase_if(columns, [&](const RatioColumn& column) {
    return scoring::find_ratio(column.ratio).generated_per_class == 0;
  });
  return columns;
}

const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio) {
  const auto found = std::ranges::find_if(rows, [&](const AccuracyRow& row) {
    return row.method == method && (row.ratio == ratio || method == augment::no_method);
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace piae::report
