#include "report/ratio_means.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"

namespace piae::report {

Block largest_block(const std::vector<std::vector<std::size_t>>& has, std::size_t least_rows,
                    std::size_t least_columns) {
  Block best;
  for (const std::vector<std::size_t>& columns : has) {
    Block block{.columns = columns};
    for (std::size_t row = 0; row < has.size(); ++row) {
      if (std::ranges::includes(has[row], columns)) block.rows.push_back(row);
    }
    const bool counts = block.rows.size() >= least_rows && columns.size() >= least_columns;
    if (counts && block.rows.size() * columns.size() > best.rows.size() * best.columns.size()) {
      best = std::move(block);
    }
  }
  return best;
}

std::optional<AccuracyRow> mean_row(const std::vector<AccuracyRow>& rows) {
  const std::vector<std::int64_t> seeds = seeds_of_any(rows);
  const Block block = largest_block(columns_of_rows(seeds.size(), rows.size(),
                                                    [&](std::size_t i, std::size_t r) {
                                                      return rows[r].at(seeds[i]).has_value();
                                                    }),
                                    1, 2);
  if (block.rows.empty()) return std::nullopt;
  AccuracyRow mean;
  mean.dataset = rows.front().dataset;
  mean.method = rows.front().method;
  mean.classifier = rows.front().classifier;
  mean.ratio = mean_of_ratios;
  mean.ratios = block.columns.size();
  for (const std::size_t i : block.rows) {
    double sum = 0;
    for (const std::size_t r : block.columns) {
      sum += *rows[r].at(seeds[i]) / static_cast<double>(mean.ratios);
    }
    mean.seeds.push_back(seeds[i]);
    mean.values.push_back(sum);
  }
  mean.summary = summarise_within(percents, mean.values);
  return mean;
}

std::vector<AccuracyRow> mean_rows(const std::vector<AccuracyRow>& rows) {
  std::vector<AccuracyRow> means;
  for (const std::string& method : methods_of(rows)) {
    if (const auto mean = mean_row(rows_of(rows, method))) means.push_back(*mean);
  }
  return means;
}

std::vector<AccuracyRow> with_means(std::vector<AccuracyRow> rows) {
  for (AccuracyRow& mean : mean_rows(rows)) rows.push_back(std::move(mean));
  return rows;
}

std::vector<AccuracyRow> cells_also_in(const std::vector<AccuracyRow>& rows,
                                       const std::vector<AccuracyRow>& others) {
  std::vector<AccuracyRow> kept;
  for (const AccuracyRow& row : rows) {
    if (row.method == augment::no_method) return rows;
    const AccuracyRow* const other = find_row(others, others.front().method, row.ratio);
    if (other == nullptr) continue;
    AccuracyRow& common = kept.emplace_back(row);
    common.seeds.clear();
    common.values.clear();
    for (std::size_t i = 0; i < row.seeds.size(); ++i) {
      if (!other->at(row.seeds[i])) continue;
      common.seeds.push_back(row.seeds[i]);
      common.values.push_back(row.values[i]);
    }
  }
  return kept;
}

}  // namespace piae::report
