#include "report/decisions_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"

namespace piae::report {

namespace {

/// Decisions of one method, classifier and ratio over a number of windows, over the seeds that have
/// such decisions.
struct DecisionRow {
  AccuracyRow row;
  std::size_t windows = 0;         ///< per decision
  double decisions = 0;            ///< mean over the seeds
  scoring::Summary accuracy = {};  ///< percent
  scoring::Summary balanced = {};  ///< percent
};

/// Returns the decisions of a row's cells over this many windows, or nothing if no seed has any.
std::optional<DecisionRow> decisions_over(std::size_t windows, const AccuracyRow& row,
                                          const run::Results& results) {
  std::vector<double> accuracies;
  std::vector<double> balanced;
  DecisionRow decisions{.row = row, .windows = windows};
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

text::Cell decisions_cell(const std::optional<DecisionRow>& decisions, std::size_t seeds) {
  if (!decisions) return no_number;
  text::Cell cell = mean_cell(decisions->balanced);
  cell.text = marked_if(decisions->balanced.count < seeds, cell.text);
  cell.source = fmt::format("{:g} decisions of each of {} seeds", decisions->decisions,
                            decisions->balanced.count);
  return cell;
}

bool has_decisions(const run::Results& results) {
  return std::ranges::any_of(results.diagnoses,
                             [](const run::Diagnosis& cell) { return !cell.decisions.empty(); });
}

std::string decisions_note(const run::Results& results, bool any_fewer) {
  const bool are_apart = results.diagnoses.front().protocol == signal::Protocol::random;
  return std::string(
             "Balanced accuracy (recall averaged over the classes) of decisions over n successive "
             "test windows of one record") +
         (are_apart ? " (with the random split they are successive among the test windows, not in "
                      "the record)"
                    : "") +
         ". A decision is the class with the largest sum of scores. Incomplete groups of n do not "
         "count. A number is missing if a class has no record with n test windows. Each method "
         "is at its ratio with the most generated windows; decisions.csv has all ratios, and plain "
         "accuracies." +
         (any_fewer ? fmt::format(" {} marks means of fewer seeds than the rest of the table: the "
                                  "others lack such records or A.h5.",
                                  mark_of_fewer_seeds)
                    : "");
}

/// Confidence of a classifier over the seeds.
struct ConfidenceRow {
  std::string name;
  AccuracyRow row;
  scoring::Summary calibration_error = {};  ///< percent
  scoring::Summary answerable = {};         ///< percent of the test windows
  bool ranks_answers = false;               ///< whether it reports its confidence in any seed
};

/// Summarises the confidence of a row's cells. Expects at least one cell in `results`.
ConfidenceRow confidence_of(const ShownRow& shown, const run::Results& results) {
  std::vector<double> errors;
  std::vector<double> shares;
  ConfidenceRow confidence{.name = shown.name, .row = shown.row};
  for (const run::Diagnosis& cell :
       run::diagnoses_of(results, {shown.row.method, shown.row.ratio, shown.row.classifier})) {
    errors.push_back(100 * cell.confidence.calibration_error);
    shares.push_back(100 * cell.confidence.answerable);
    confidence.ranks_answers = confidence.ranks_answers || cell.confidence.ranks_answers;
  }
  confidence.calibration_error = summarise_within(percents, errors);
  confidence.answerable = summarise_within(percents, shares);
  return confidence;
}

text::Table confidence_table(const std::vector<ConfidenceRow>& rows) {
  using Row = ConfidenceRow;
  const auto cell_of = [](scoring::Summary Row::*summary) {
    return [summary](const Row& row) {
      text::Cell cell = mean_cell(row.*summary);
      cell.source = fmt::format("/scores of {} seeds", (row.*summary).count);
      return cell;
    };
  };
  Columns<Row> columns;
  columns.words("method", &Row::name)
      .words("ratio", [](const Row& row) { return ratio_label(row.row.ratio, row.row.true_ratio); })
      .numbers("calibration error", cell_of(&Row::calibration_error))
      .numbers("answered", cell_of(&Row::answerable))
      .numbers("95 % interval", [](const Row& row) { return interval_label(row.answerable); })
      .name_fields(&Row::row)
      .field("seeds", [](const Row& row) { return count_cell(row.answerable.count); })
      .summary_fields("calibration_error_mean", "calibration_error_", &Row::calibration_error)
      .summary_fields("answerable_mean", "answerable_", &Row::answerable)
      .field("tells", [](const Row& row) { return row.ranks_answers ? "1" : "0"; });
  return columns.table(rows);
}

/// `silent` are the names of the rows whose classifier does not report its confidence.
std::string confidence_note(const std::vector<std::string>& silent) {
  return fmt::format(
             "Calibration error: difference between the score of the predicted class and how often "
             "the prediction is correct, averaged over ten bins of a seed's test windows. "
             "Answered: the largest share of the test windows that can be answered with at least "
             "{} % of the answers correct, if those with the lowest scores are refused first; 100 "
             "if none must be refused, 0 if no threshold suffices. The threshold comes from the "
             "same windows, so it shows how well the scores rank them, not what a user would get.",
             scoring::wanted_precision_percent) +
         (silent.empty()
              ? ""
              : fmt::format(" No confidence is reported by {}: all windows are answered, or none.",
                            listed(silent)));
}

}  // namespace

std::string decisions_csv(const std::vector<AccuracyRow>& rows, const run::Results& results) {
  std::vector<DecisionRow> all;
  for (const AccuracyRow& row : rows) {
    for (const std::size_t windows : scoring::decided_windows) {
      if (auto decisions = decisions_over(windows, row, results)) all.push_back(*decisions);
    }
  }
  using Row = DecisionRow;
  Columns<Row> columns;
  columns.name_fields(&Row::row)
      .field("windows", [](const Row& row) { return count_cell(row.windows); })
      .field("seeds", [](const Row& row) { return count_cell(row.accuracy.count); })
      .field("decisions", [](const Row& row) { return fmt::format("{:g}", row.decisions); })
      .summary_fields("mean", "", &Row::accuracy)
      .summary_fields("balanced_mean", "balanced_", &Row::balanced);
  return columns.table(all).csv();
}

std::vector<Section> decision_sections(const ClassifierRows& block, const run::Results& results) {
  if (!has_decisions(results)) return {};
  text::Table table({"method", "ratio"}, 2);
  text::Cells counts{"decisions of a seed", ""};
  bool any_fewer = false;
  for (const std::size_t windows : scoring::decided_windows) {
    table.column({counted(windows, "window"), true});
    const auto of_any = decisions_over(windows, block.rows.front(), results);
    counts.push_back(of_any ? number_label(of_any->decisions, {.decimals = 0}) : no_number);
  }
  for (const auto& [name, row] : rows_with_most_windows(block)) {
    text::Cells cells{name, ratio_label(row.ratio, row.true_ratio)};
    for (const std::size_t windows : scoring::decided_windows) {
      const std::optional<DecisionRow> decisions = decisions_over(windows, row, results);
      any_fewer = any_fewer || (decisions && decisions->balanced.count < row.seeds.size());
      cells.push_back(decisions_cell(decisions, row.seeds.size()));
    }
    table.row(std::move(cells), looks_of(row.method));
  }
  table.row(counts);
  const std::string& dataset = block.rows.front().dataset;
  return {PaperReference(dataset, block.classifier)
              .none()
              .of({"decisions",
                   "Decisions over several windows of a record on " + dataset + ", percent",
                   decisions_note(results, any_fewer), table})};
}

std::string decisions_gap(const run::Results& results) {
  if (has_decisions(results)) return "";
  return "Decisions over several windows of a record are left out: the run does not hold the test "
         "windows (A.h5 of each seed), which name the record of each window.";
}

std::string confidence_csv(const std::vector<AccuracyRow>& rows, const run::Results& results) {
  std::vector<ConfidenceRow> all;
  for (const AccuracyRow& row : rows) all.push_back(confidence_of({row.method, row}, results));
  return confidence_table(all).csv();
}

std::vector<Section> confidence_sections(const ClassifierRows& block, const run::Results& results) {
  std::vector<ConfidenceRow> rows;
  std::vector<std::string> silent;
  for (const ShownRow& shown : rows_with_most_windows(block)) {
    rows.push_back(confidence_of(shown, results));
    if (!rows.back().ranks_answers) silent.push_back(shown.name);
  }
  const std::string& dataset = block.rows.front().dataset;
  return {PaperReference(dataset, block.classifier)
              .none()
              .of({"confidence",
                   fmt::format("Share answered at {} % precision on {}, percent",
                               scoring::wanted_precision_percent, dataset),
                   confidence_note(silent), confidence_table(rows)})};
}

}  // namespace piae::report
