#include "report/columns.hpp"

#include <spdlog/fmt/fmt.h>

namespace piae::report {

text::Cell labelled_cell(double number, const std::string& label) {
  text::Cell cell = label;
  cell.number = number;
  return cell;
}

text::Cell number_cell(double number, NumberStyle style) {
  text::Cell cell = labelled_cell(number, number_label(number, style));
  cell.field = four_decimals(number);
  return cell;
}

text::Cell count_cell(std::size_t count) {
  return labelled_cell(static_cast<double>(count), std::to_string(count));
}

text::Cell mean_cell(const scoring::Summary& summary, NumberStyle style) {
  text::Cell cell = number_cell(summary.mean, style);
  cell.text = mean_label(summary, style);
  return cell;
}

text::Cell interval_cell(const scoring::Summary& summary, NumberStyle style) {
  text::Cell cell = interval_label(summary, style);
  cell.field = summary.interval ? four_decimals(summary.interval->low) : "";
  return cell;
}

text::Cell share_cell(const scoring::Share& share) {
  text::Cell cell = no_number;
  cell.field = "";
  if (share.of == 0) return cell;
  cell = number_cell(share.percent(), percent_style);
  cell.source = fmt::format("{} of {} windows", share.count, share.of);
  return cell;
}

text::Cell recall_cell(const scoring::Share& share) {
  text::Cell cell = share_cell(share);
  for (int level = 4; share.of > 0 && level >= 1 && cell.looks.empty(); --level) {
    if (share.percent() < 20.0 * (5 - level)) cell.looks = fmt::format("low-{}", level);
  }
  return cell;
}

}  // namespace piae::report
