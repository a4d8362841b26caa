#include "page/recall_view.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "page/recall_cells.hpp"
#include "page/table.hpp"
#include "page/words.hpp"
#include "report/labels.hpp"

namespace piae::page {

namespace {

Row row_of_method(const DatasetContents& contents, const MethodConfusion& method) {
  Row row{.cells = {{.content = report::method_label(method.method)}},
          .looks = augment::is_ceiling(method.method) ? "ceiling" : ""};
  for (std::size_t truth = 0; truth < contents.classes.size(); ++truth) {
    row.cells.push_back(recall_cell(scoring::recall_of(method.confusion, truth)));
  }
  row.cells.push_back(share_cell(scoring::missed_faults(method.confusion, contents.classes)));
  row.cells.push_back(share_cell(scoring::false_alarms(method.confusion, contents.classes)));
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
      (ratio.empty() ? "<ratio>" : ratio) + "/" + scoring::paper_classifier +
      "/diagnosis.h5, summed over seeds; none from its own ratio. Shaded where less than 80, 60, "
      "40 and 20 % are recognised. Missed faults: windows with a fault that are taken for healthy "
      "ones; false alarms: healthy windows that are taken for a fault.";
  return html(table);
}

}  // namespace piae::page
