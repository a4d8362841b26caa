#include "page/recall_cells.hpp"

#include <spdlog/fmt/fmt.h>

#include "report/labels.hpp"

namespace piae::page {

namespace {

/// The less is recognised, the stronger a cell is shaded: "low-1" to "low-4", nothing from 80 % on.
std::string shade_of(double recall_percent) {
  for (int level = 4; level >= 1; --level) {
    if (recall_percent < 20.0 * (5 - level)) return fmt::format("low-{}", level);
  }
  return "";
}

}  // namespace

Cell share_cell(const scoring::Share& share) {
  if (share.of == 0) return {.content = report::no_number};
  return {.content = fmt::format("{:.1f}", share.percent()),
          .number = share.percent(),
          .from = fmt::format("{} of {} windows", share.count, share.of)};
}

Cell recall_cell(const scoring::Share& share) {
  Cell cell = share_cell(share);
  if (share.of > 0) cell.looks = shade_of(share.percent());
  return cell;
}

}  // namespace piae::page
