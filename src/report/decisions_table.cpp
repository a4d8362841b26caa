#include "report/decisions_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "report/bounded_summary.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/shown_rows.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

std::string count_label(double decisions) { return number_label(decisions, {.decimals = 0}); }

std::string cell_label(const std::optional<DecisionRow>& decisions, std::size_t seeds) {
  if (!decisions) return no_number;
  return marked_if(decisions->balanced.count < seeds, mean_label(decisions->balanced));
}

std::string fewer_note(bool any_fewer) {
  if (!any_fewer) return "";
  return fmt::format(
      " {} marks means of fewer seeds than the table is of: not each has such records, or its "
      "A.h5.",
      mark_of_fewer_seeds);
}

}  // namespace

std::optional<DecisionRow> decisions_over(std::size_t windows, const AccuracyRow& row,
                                          const run::Results& results) {
  std::vector<double> accuracies;
  std::vector<double> balanced;
  DecisionRow decisions;
  decisions.windows = windows;
  for (const run::Diagnosis& cell :
       run::diagnoses_of(results, {row.method, row.ratio, row.classifier})) {
    const auto rates = std::ranges::find(cell.decisions, windows, &scoring::DecisionRates::windows);
    if (rates == cell.decisions.end()) continue;
    accuracies.push_back(100 * rates->accuracy);
    balanced.push_back(100 * rates->balanced);
    decisions.decisions += static_cast<double>(rates->decisions);
  }
  if (accuracies.empty()) return std::nullopt;
  decisions.decisions /= static_cast<double>(accuracies.size());
  decisions.accuracy = summarise_within(percents, accuracies);
  decisions.balanced = summarise_within(percents, balanced);
  return decisions;
}

bool has_decisions(const run::Results& results) {
  return std::ranges::any_of(results.diagnoses,
                             [](const run::Diagnosis& cell) { return !cell.decisions.empty(); });
}

std::string decisions_gap(const run::Results& results) {
  if (has_decisions(results)) return "";
  return "Decisions over several windows of a record are left out: the run does not hold the test "
         "windows (A.h5 of each seed), which say of which record they are.";
}

std::string decisions_note(const run::Results& results) {
  const bool are_apart = results.diagnoses.front().protocol == signal::Protocol::random;
  return std::string(
             "Balanced accuracy, the mean over the classes of the share that is "
             "recognised, of decisions over n test windows of one record that follow each "
             "other") +
         (are_apart ? " (the random split makes them neighbours among the test windows, not in the "
                      "record)"
                    : "") +
         ": the class with the largest sum of scores. What fills no group of n is left out; there "
         "is no number where a class has no record with n test windows. Each method is at its "
         "ratio with the most generated windows; decisions.csv has all, and plain accuracies.";
}

std::string decisions_csv(const std::vector<AccuracyRow>& rows, const run::Results& results) {
  std::string text =
      text::csv_line({"dataset", "method", "classifier", "ratio", "windows", "seeds", "decisions",
                      "mean", "std", "ci95_low", "ci95_high", "balanced_mean", "balanced_std",
                      "balanced_ci95_low", "balanced_ci95_high"});
  for (const AccuracyRow& row : rows) {
    for (const std::size_t windows : scoring::decided_windows) {
      const std::optional<DecisionRow> decisions = decisions_over(windows, row, results);
      if (!decisions) continue;
      text += joined_csv_line(
          {{row.dataset, row.method, row.classifier, row.ratio, std::to_string(windows),
            std::to_string(decisions->accuracy.count), fmt::format("{:g}", decisions->decisions)},
           mean_fields(decisions->accuracy),
           interval_fields(decisions->accuracy),
           mean_fields(decisions->balanced),
           interval_fields(decisions->balanced)});
    }
  }
  return text;
}

std::vector<Section> decision_sections(const ClassifierRows& block, const run::Results& results) {
  if (!has_decisions(results)) return {};
  std::vector<std::string> header{"method", "ratio"};
  std::vector<std::string> counts{"decisions of a seed", ""};
  bool any_fewer = false;
  for (const std::size_t windows : scoring::decided_windows) {
    header.push_back(fmt::format("{} window{}", windows, windows == 1 ? "" : "s"));
    const auto of_any = decisions_over(windows, block.rows.front(), results);
    counts.push_back(of_any ? count_label(of_any->decisions) : no_number);
  }
  text::Table table(header, 2);
  for (const auto& [name, row] : rows_with_most_windows(block)) {
    std::vector<std::string> cells{name, ratio_label(row.ratio, row.true_ratio)};
    for (const std::size_t windows : scoring::decided_windows) {
      const std::optional<DecisionRow> decisions = decisions_over(windows, row, results);
      any_fewer = any_fewer || (decisions && decisions->balanced.count < row.seeds.size());
      cells.push_back(cell_label(decisions, row.seeds.size()));
    }
    table.row(cells);
  }
  table.row(counts);
  const std::string& dataset = block.rows.front().dataset;
  return {PaperReference(dataset, block.classifier)
              .none()
              .of({"decisions",
                   "Decisions over several windows of a record on " + dataset + ", percent",
                   decisions_note(results) + fewer_note(any_fewer), table})};
}

}  // namespace piae::report
