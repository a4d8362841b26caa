#include "diagnosis/adapting.hpp"

#include <algorithm>
#include <cstddef>

namespace piae::diagnosis {

namespace {

bool is_tested(const signal::WindowSet& windows, std::size_t i) {
  if (windows.condition.empty() || windows.condition[i] == signal::every_condition) return true;
  return windows.info.conditions[static_cast<std::size_t>(windows.condition[i])].test;
}

}  // namespace

signal::WindowSet without_labels(const signal::WindowSet& normal, const signal::WindowSet& hidden) {
  signal::WindowSet all = hidden;
  for (std::size_t i = 0; i < normal.size(); ++i) {
    if (is_tested(normal, i)) all.append(normal, i);
  }
  std::ranges::fill(all.labels, all.info.healthy_label());
  return all;
}

}  // namespace piae::diagnosis
