#include "page/decisions_view.hpp"

#include <spdlog/fmt/fmt.h>

#include "augment/catalogue.hpp"
#include "page/table.hpp"
#include "report/confidence_table.hpp"
#include "report/decisions_table.hpp"
#include "report/labels.hpp"
#include "report/shown_rows.hpp"

namespace piae::page {

namespace {

Cell summary_cell(const scoring::Summary& summary, const std::string& from) {
  return {.content = report::mean_label(summary), .number = summary.mean, .from = from};
}

Cell decisions_cell(std::size_t windows, const report::AccuracyRow& row,
                    const run::Results& results) {
  const auto decisions = report::decisions_over(windows, row, results);
  if (!decisions) return {.content = report::no_number};
  return summary_cell(decisions->balanced,
                      fmt::format("{:g} decisions of each of {} seeds", decisions->decisions,
                                  decisions->balanced.count));
}

Row row_of(const report::ShownRow& shown, const report::ConfidenceRow& confidence,
           const run::Results& results, bool with_decisions) {
  const report::AccuracyRow& row = shown.row;
  Row line{.cells = {{.content = shown.name},
                     {.content = report::ratio_label(row.ratio, row.true_ratio)}},
           .looks = augment::is_ceiling(row.method) ? "ceiling" : ""};
  if (with_decisions) {
    for (const std::size_t windows : scoring::decided_windows) {
      line.cells.push_back(decisions_cell(windows, row, results));
    }
  }
  const std::string from = fmt::format("/scores of {} seeds", confidence.answerable.count);
  line.cells.push_back(summary_cell(confidence.answerable, from));
  line.cells.push_back(summary_cell(confidence.calibration_error, from));
  return line;
}

Table table_of(const DatasetContents& contents, const report::ClassifierRows& block) {
  const bool with_decisions = report::has_decisions(contents.results);
  Table table{.caption = fmt::format("Decisions over several windows, and what may be answered, on "
                                     "{}, percent, by {}",
                                     contents.name, block.classifier),
              .columns = {{"method"}, {"ratio"}}};
  if (with_decisions) {
    for (const std::size_t windows : scoring::decided_windows) {
      table.columns.push_back({fmt::format("{} window{}", windows, windows == 1 ? "" : "s"), true});
    }
  }
  table.columns.push_back({"answered", true});
  table.columns.push_back({"calibration error", true});
  std::vector<std::string> silent;
  for (const report::ShownRow& shown : report::rows_with_most_windows(block)) {
    const report::ConfidenceRow confidence = report::confidence_of(shown.row, contents.results);
    table.rows.push_back(row_of(shown, confidence, contents.results, with_decisions));
    if (!confidence.tells) silent.push_back(shown.name);
  }
  table.below = (with_decisions ? report::decisions_note(contents.results)
                                : report::decisions_gap(contents.results)) +
                " " + report::confidence_note(silent);
  return table;
}

}  // namespace

Html decisions_view(const DatasetContents& contents) {
  if (contents.rows.empty()) return element("p", "No diagnosis is there yet.");
  Html view;
  for (const report::ClassifierRows& block : report::by_classifier(contents.rows)) {
    view += html(table_of(contents, block));
  }
  return view;
}

}  // namespace piae::page
