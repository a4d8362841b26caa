#include "report/shown_rows.hpp"

#include <algorithm>

#include "report/labels.hpp"

namespace piae::report {

std::vector<ShownRow> rows_with_most_windows(const ClassifierRows& block) {
  std::vector<ShownRow> shown;
  for (const std::string& method : methods_of(block.rows)) {
    const std::vector<AccuracyRow> own = rows_of(block.rows, method);
    shown.push_back({method_label(method),
                     *std::ranges::max_element(own, {}, &AccuracyRow::generated_per_class)});
  }
  if (block.bar) shown.push_back({bar_label(*block.bar), *block.bar});
  return shown;
}

}  // namespace piae::report
