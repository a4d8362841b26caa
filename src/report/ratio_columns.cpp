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
