#include "report/accuracy_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "augment/catalogue.hpp"
#include "report/bounded_summary.hpp"
#include "report/classifier_rows.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "text/csv.hpp"
#include "text/table.hpp"

namespace piae::report {

namespace {

void add_published(AccuracyRow& row, const Published& published) {
  if (row.classifier != scoring::paper_classifier) return;
  const std::optional<Counterpart> beside = PaperReference(row.dataset).beside();
  if (!beside) return;
  const auto percent = published.percent(beside->paper.name, row.method, row.ratio);
  (beside->own ? row.published : row.orientation) = percent;
}

std::optional<double> difference(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(*a - *b) : std::nullopt;
}

/// Without values where the rows have no seed in common.
AccuracyRow gain_of(AccuracyRow row, const AccuracyRow& baseline) {
  const Pairs pairs = pairs_of(row, baseline);
  row.seeds = pairs.seeds;
  row.values.resize(pairs.seeds.size());
  std::ranges::transform(pairs.first, pairs.second, row.values.begin(), std::minus());
  if (row.values.empty()) return row;
  row.summary = summarise_within(differences_of_percents, row.values);
  row.kind.reset();
  row.published = difference(row.published, baseline.published);
  row.orientation = difference(row.orientation, baseline.orientation);
  return row;
}

std::string as_published(std::optional<double> value) {
  return value ? fmt::format("{:g}", *value) : "";
}

void add_line(text::Table& table, const std::string& name, const AccuracyRow& row,
              bool with_kinds) {
  std::vector<std::string> cells{name,
                                 ratio_label(row.ratio, row.true_ratio),
                                 std::to_string(row.generated_per_class),
                                 std::to_string(row.summary.count),
                                 mean_label(row.summary),
                                 interval_label(row.summary)};
  if (with_kinds) {
    cells.push_back(row.kind ? mean_label(*row.kind) : "");
  } else {
    cells.push_back(as_published(row.published));
  }
  table.row(cells);
}

}  // namespace

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
  std::vector<double> kinds;
  for (const run::Diagnosis& cell : cells) {
    row.seeds.push_back(cell.seed);
    row.values.push_back(100 * cell.accuracy);
    if (cell.kind_accuracy) kinds.push_back(100 * *cell.kind_accuracy);
  }
  row.summary = summarise_within(percents, row.values);
  if (!kinds.empty()) row.kind = summarise_within(percents, kinds);
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

bool tell_kinds(const std::vector<AccuracyRow>& rows) {
  return std::ranges::any_of(rows, [](const AccuracyRow& row) { return row.kind.has_value(); });
}

std::vector<AccuracyRow> rows_of(const std::vector<AccuracyRow>& rows, const std::string& method) {
  std::vector<AccuracyRow> own;
  std::ranges::copy_if(rows, std::back_inserter(own),
                       [&](const AccuracyRow& row) { return row.method == method; });
  return own;
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

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  const bool with_kinds = tell_kinds(rows);
  std::vector<std::string> header{
      "dataset", "method",   "classifier", "ratio",    "generated_per_class", "seeds", "mean",
      "std",     "ci95_low", "ci95_high",  "published"};
  const std::vector<std::string> of_kinds{"kind_mean", "kind_std", "kind_ci95_low",
                                          "kind_ci95_high"};
  if (with_kinds) header.insert(header.end(), of_kinds.begin(), of_kinds.end());
  std::string text = text::csv_line(header);
  for (const AccuracyRow& row : rows) {
    text += joined_csv_line(
        {{row.dataset, row.method, row.classifier, row.ratio,
          std::to_string(row.generated_per_class), std::to_string(row.summary.count)},
         mean_fields(row.summary),
         interval_fields(row.summary),
         {as_published(row.published)},
         with_kinds ? mean_fields(*row.kind) : std::vector<std::string>{},
         with_kinds ? interval_fields(*row.kind) : std::vector<std::string>{}});
  }
  return text;
}

std::string accuracy_text(const std::vector<AccuracyRow>& rows) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  const bool with_kinds = tell_kinds(rows);
  std::string text;
  for (const ClassifierRows& block : blocks) {
    text::Table table({"method", "ratio", "generated", "seeds", "accuracy %", "95 % interval",
                       with_kinds ? "kind %" : "paper"},
                      2);
    for (const AccuracyRow& row : block.rows) {
      add_line(table, method_label(row.method), row, with_kinds);
    }
    if (block.bar) add_line(table, bar_label(*block.bar), *block.bar, with_kinds);
    if (blocks.size() > 1) text += "by " + block.classifier + '\n';
    text += table.plain();
  }
  return text;
}

}  // namespace piae::report
