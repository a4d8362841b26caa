#include "report/recall_table.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "augment/catalogue.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

/// Confusion of the paper's classifier, trained with a method's windows, summed over seeds.
struct MethodConfusion {
  std::string method;
  std::size_t seeds = 0;
  scoring::Confusion confusion = {};
};

/// Returns the ratio at which the most methods have a row; if several, the one with the most
/// generated windows.
std::string ratio_to_show(const std::vector<AccuracyRow>& rows) {
  std::map<std::int64_t, std::pair<std::size_t, std::string>> methods_by_generated;
  for (const AccuracyRow& row : rows) {
    auto& [count, ratio] = methods_by_generated[row.generated_per_class];
    ++count;
    ratio = row.ratio;
  }
  std::size_t most = 0;
  std::string shown;
  for (const auto& [generated, methods] : methods_by_generated) {
    if (methods.first < most) continue;
    most = methods.first;
    shown = methods.second;
  }
  return shown;
}

/// Returns the confusions of the paper's classifier at this ratio and without generated windows.
std::vector<MethodConfusion> confusions_of(const std::vector<run::Diagnosis>& cells,
                                           const std::string& ratio) {
  std::vector<MethodConfusion> confusions;
  for (const run::Diagnosis& cell : cells) {
    if (cell.classifier != scoring::paper_classifier) continue;
    if (cell.ratio != ratio && cell.method != augment::no_method) continue;
    auto of_method = std::ranges::find(confusions, cell.method, &MethodConfusion::method);
    if (of_method == confusions.end()) {
      of_method = confusions.insert(of_method, {.method = cell.method});
    }
    scoring::add(of_method->confusion, cell.confusion);
    ++of_method->seeds;
  }
  return confusions;
}

text::Table recall_of_methods(const std::vector<MethodConfusion>& confusions,
                              const std::vector<signal::ClassInfo>& classes) {
  text::Table table({"method"}, 1);
  for (const signal::ClassInfo& info : classes) table.column({info.name, true});
  for (const char* heading : {"missed faults", "false alarms", "seeds"}) {
    table.column({heading, true});
  }
  for (const auto& [method, seeds, confusion] : confusions) {
    text::Cells cells{method_label(method)};
    for (std::size_t truth = 0; truth < classes.size(); ++truth) {
      cells.push_back(recall_cell(scoring::recall_of(confusion, truth)));
    }
    cells.push_back(share_cell(scoring::missed_faults(confusion, classes)));
    cells.push_back(share_cell(scoring::false_alarms(confusion, classes)));
    cells.push_back(count_cell(seeds));
    table.row(std::move(cells), looks_of(method));
  }
  return table;
}

}  // namespace

std::vector<Section> recall_sections(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results) {
  const std::string ratio = ratio_to_show(rows_by(rows, scoring::paper_classifier));
  const std::vector<MethodConfusion> confusions = confusions_of(results.diagnoses, ratio);
  if (confusions.empty()) return {};
  const bool any_method = std::ranges::any_of(
      confusions, [](const auto& each) { return each.method != augment::no_method; });
  const std::string& dataset = rows.front().dataset;
  return {
      {.key = "recall",
       .title = "Windows of each class that are recognised on " + dataset +
                (any_method ? " at " + short_ratio_label(ratio) : "") + ", percent",
       .note =
           "From /confusion of " + dataset + "/seed*/<method>/" + (any_method ? ratio : "<ratio>") +
           "/" + scoring::paper_classifier +
           "/diagnosis.h5, summed over seeds; none from its own ratio. Shaded where less "
           "than 80, 60, 40 and 20 % are recognised. Missed faults: fault windows that are "
           "classified as healthy; false alarms: healthy windows that are classified as a fault.",
       .table = recall_of_methods(confusions, results.diagnoses.front().classes)}};
}

}  // namespace piae::report
