#include "page/recall_view.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "page/table.hpp"
#include "page/words.hpp"
#include "report/labels.hpp"

namespace piae::page {

namespace {

/// What share of a number of windows something happened to, in percent.
struct Share {
  std::int64_t count = 0;
  std::int64_t of = 0;
  [[nodiscard]] double percent() const {
    return 100.0 * static_cast<double>(count) / static_cast<double>(of);
  }
};

Share recall_of(const scoring::Confusion& confusion, std::size_t truth) {
  Share share{.count = confusion.at(truth, truth)};
  for (std::size_t k = 0; k < confusion.classes; ++k) share.of += confusion.at(truth, k);
  return share;
}

bool is_healthy(const signal::ClassInfo& info) { return info.defect == signal::Defect::none; }

/// Windows with a fault that were taken for healthy ones, or healthy ones that were taken for
/// faulty.
Share mistaken(const std::vector<signal::ClassInfo>& classes, const scoring::Confusion& confusion,
               bool truly_healthy) {
  Share share;
  for (std::size_t truth = 0; truth < classes.size(); ++truth) {
    if (is_healthy(classes[truth]) != truly_healthy) continue;
    for (std::size_t k = 0; k < classes.size(); ++k) {
      share.of += confusion.at(truth, k);
      if (is_healthy(classes[k]) != truly_healthy) share.count += confusion.at(truth, k);
    }
  }
  return share;
}

/// The less is recognised, the stronger a cell is shaded: "low-1" to "low-4", nothing from 80 % on.
std::string shade_of(double recall_percent) {
  for (int level = 4; level >= 1; --level) {
    if (recall_percent < 20.0 * (5 - level)) return fmt::format("low-{}", level);
  }
  return "";
}

Cell share_cell(const Share& share) {
  if (share.of == 0) return {.content = report::no_number};
  return {.content = fmt::format("{:.1f}", share.percent()),
          .number = share.percent(),
          .from = fmt::format("{} of {} windows", share.count, share.of)};
}

Cell recall_cell(const Share& share) {
  Cell cell = share_cell(share);
  if (share.of > 0) cell.looks = shade_of(share.percent());
  return cell;
}

Row row_of_method(const DatasetContents& contents, const MethodConfusion& method) {
  Row row{.cells = {{.content = report::method_label(method.method)}},
          .looks = augment::is_ceiling(method.method) ? "ceiling" : ""};
  for (std::size_t truth = 0; truth < contents.classes.size(); ++truth) {
    row.cells.push_back(recall_cell(recall_of(method.confusion, truth)));
  }
  row.cells.push_back(share_cell(mistaken(contents.classes, method.confusion, false)));
  row.cells.push_back(share_cell(mistaken(contents.classes, method.confusion, true)));
  row.cells.push_back(number_cell(static_cast<double>(method.seeds), std::to_string(method.seeds)));
  return row;
}

std::string ratio_of_methods(const DatasetContents& contents) {
  const auto method = std::ranges::find_if(contents.confusions, [](const MethodConfusion& each) {
    return each.method != augment::no_method;
  });
  return method == contents.confusions.end() ? "" : method->ratio;
}

}  // namespace

Html recall_view(const DatasetContents& contents) {
  if (contents.confusions.empty()) return element("p", "No diagnosis is there yet.");
  const std::string ratio = ratio_of_methods(contents);
  const std::string at = ratio.empty() ? "" : " at " + report::short_ratio_label(ratio);
  Table table{
      .caption = "Windows of each class that are recognised on " + contents.name + at + ", percent",
      .columns = {{"method"}}};
  for (const signal::ClassInfo& info : contents.classes) table.columns.push_back({info.name, true});
  for (const char* title : {"missed faults", "false alarms", "seeds"}) {
    table.columns.push_back({title, true});
  }
  for (const MethodConfusion& method : contents.confusions) {
    table.rows.push_back(row_of_method(contents, method));
  }
  table.below =
      "From /confusion of " + contents.name + "/seed*/<method>/" +
      (ratio.empty() ? "<ratio>" : ratio) +
      "/diagnosis.h5, summed over seeds; none from its own ratio. Shaded where less than 80, 60, "
      "40 and 20 % are recognised. Missed faults: windows with a fault that are taken for healthy "
      "ones; false alarms: healthy windows that are taken for a fault.";
  return html(table);
}

}  // namespace piae::page
