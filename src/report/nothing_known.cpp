#include "report/nothing_known.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

bool is_rule(const AccuracyRow& row) { return row.method == augment::no_method; }
bool is_of_ceiling(const AccuracyRow& row) { return augment::is_ceiling(row.method); }
bool is_of_method(const AccuracyRow& row) { return !is_rule(row) && !is_of_ceiling(row); }

std::string named(const AccuracyRow& row) {
  if (is_rule(row)) return fmt::format("{} ({:.1f} %)", row.classifier, row.summary.mean);
  return fmt::format("{} by {} ({:.1f} %, {})", row.method, row.classifier, row.summary.mean,
                     short_ratio_label(row.ratio));
}

}  // namespace

std::string most_accurate_without_known(const std::vector<AccuracyRow>& rows) {
  std::vector<std::string> parts;
  const auto add_best = [&](const std::string& with, bool (*of_group)(const AccuracyRow&)) {
    const AccuracyRow* best = nullptr;
    for (const AccuracyRow& row : rows) {
      if (!of_group(row)) continue;
      if (best == nullptr || row.summary.mean > best->summary.mean) best = &row;
    }
    if (best != nullptr) parts.push_back(with + " " + named(*best));
  };
  add_best("with generated windows", is_of_method);
  add_best("by a rule", is_rule);
  add_best("with real windows in their place", is_of_ceiling);
  return parts.empty() ? "" : "Right in most test windows: " + listed(parts) + ".";
}

}  // namespace piae::report
