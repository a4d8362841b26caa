#include "report/ratio_columns.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

std::vector<RatioColumn> ratio_columns(const std::vector<AccuracyRow>& rows) {
  std::vector<RatioColumn> columns;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const auto row = std::ranges::find(rows, ratio.name, &AccuracyRow::ratio);
    if (row != rows.end()) {
      columns.push_back({ratio.name, ratio_label(row->ratio, row->true_ratio)});
    }
  }
  if (std::ranges::find(rows, mean_of_ratios, &AccuracyRow::ratio) != rows.end()) {
    columns.push_back({mean_of_ratios, "mean of ratios"});
  }
  return columns;
}

std::vector<RatioColumn> compared_columns(const std::vector<AccuracyRow>& rows) {
  std::vector<RatioColumn> columns = ratio_columns(rows);
  std::erase_if(columns, [&](const RatioColumn& column) {
    return column.ratio != mean_of_ratios &&
           scoring::find_ratio(column.ratio).generated_per_class == 0;
  });
  return columns;
}

std::vector<AccuracyRow> with_means(std::vector<AccuracyRow> rows) {
  for (AccuracyRow& mean : mean_rows(rows)) rows.push_back(std::move(mean));
  return rows;
}

const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& method,
                            const std::string& ratio) {
  const auto found = std::ranges::find_if(rows, [&](const AccuracyRow& row) {
    return row.method == method && (row.ratio == ratio || method == augment::no_method);
  });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace piae::report
