#include "report/csv_fields.hpp"

#include <spdlog/fmt/fmt.h>

#include "text/csv.hpp"

namespace piae::report {

std::string four_decimals(std::optional<double> number) {
  return number ? fmt::format("{:.4f}", *number) : "";
}

std::vector<std::string> mean_fields(const scoring::Summary& summary) {
  return {four_decimals(summary.mean), four_decimals(summary.deviation)};
}

std::vector<std::string> interval_fields(const scoring::Summary& summary) {
  if (!summary.interval) return {"", ""};
  return {four_decimals(summary.interval->low), four_decimals(summary.interval->high)};
}

std::string joined_csv_line(const std::vector<std::vector<std::string>>& groups) {
  std::vector<std::string> fields;
  for (const auto& group : groups) fields.insert(fields.end(), group.begin(), group.end());
  return text::csv_line(fields);
}

}  // namespace piae::report
