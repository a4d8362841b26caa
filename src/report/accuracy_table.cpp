#include "report/accuracy_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "report/csv.hpp"
#include "report/text_table.hpp"

namespace piae::report {

namespace {

AccuracyRow row_of(const Combination& combination, const Grid& grid, const Results& results,
                   const Published& published) {
  AccuracyRow row;
  row.dataset = grid.dataset;
  row.method = combination.method;
  row.ratio = combination.ratio;
  for (const Diagnosis& cell : results.diagnoses) {
    if (cell.method != row.method || cell.ratio != row.ratio) continue;
    row.generated_per_class = cell.generated_per_class;
    row.true_ratio = cell.true_ratio;
    row.percents.push_back(100 * cell.accuracy);
  }
  row.summary = scoring::summarise(row.percents);
  row.published = published.percent(row.dataset, row.method, row.ratio);
  return row;
}

std::string fixed(std::optional<double> value) {
  return value ? fmt::format("{:.4f}", *value) : "";
}

std::string as_published(std::optional<double> value) {
  return value ? fmt::format("{:g}", *value) : "";
}

}  // namespace

std::vector<AccuracyRow> accuracy_rows(const Grid& grid, const Results& results,
                                       const Published& published) {
  std::vector<AccuracyRow> rows;
  for (const Combination& combination : grid.combinations) {
    rows.push_back(row_of(combination, grid, results, published));
  }
  return rows;
}

std::string accuracy_csv(const std::vector<AccuracyRow>& rows) {
  std::string text = csv_line({"dataset", "method", "ratio", "generated_per_class", "seeds", "mean",
                               "std", "ci95_low", "ci95_high", "published"});
  for (const AccuracyRow& row : rows) {
    const auto& interval = row.summary.interval;
    text += csv_line({row.dataset, row.method, row.ratio, std::to_string(row.generated_per_class),
                      std::to_string(row.summary.count), fixed(row.summary.mean),
                      fixed(row.summary.deviation), interval ? fixed(interval->low) : "",
                      interval ? fixed(interval->high) : "", as_published(row.published)});
  }
  return text;
}

std::string accuracy_text(const std::vector<AccuracyRow>& rows) {
  TextTable table({"method", "ratio", "generated", "seeds", "accuracy %", "95 % interval", "paper"},
                  2);
  for (const AccuracyRow& row : rows) {
    table.row({row.method, ratio_label(row), std::to_string(row.generated_per_class),
               std::to_string(row.summary.count), mean_label(row.summary),
               interval_label(row.summary), as_published(row.published)});
  }
  return table.plain();
}

std::string ratio_label(const AccuracyRow& row) {
  const std::size_t to = row.ratio.find("to");
  const double named = std::stod(row.ratio.substr(0, to)) / std::stod(row.ratio.substr(to + 2));
  const std::string label = row.ratio.substr(0, to) + ":" + row.ratio.substr(to + 2);
  const bool as_named = std::abs(row.true_ratio - named) < 0.005 * named;
  return as_named ? label : fmt::format("{} ({:.3g}:1)", label, row.true_ratio);
}

std::string mean_label(const scoring::Summary& summary) {
  if (!summary.deviation) return fmt::format("{:.2f}", summary.mean);
  return fmt::format("{:.2f} ± {:.2f}", summary.mean, *summary.deviation);
}

std::string interval_label(const scoring::Summary& summary) {
  if (!summary.interval) return "";
  return fmt::format("[{:.2f}, {:.2f}]", summary.interval->low, summary.interval->high);
}

}  // namespace piae::report
