#include "report/confidence_table.hpp"

#include <spdlog/fmt/fmt.h>

#include "report/bounded_summary.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/shown_rows.hpp"
#include "text/csv.hpp"

namespace piae::report {

ConfidenceRow confidence_of(const AccuracyRow& row, const run::Results& results) {
  std::vector<double> errors;
  std::vector<double> shares;
  ConfidenceRow confidence;
  for (const run::Diagnosis& cell :
       run::diagnoses_of(results, {row.method, row.ratio, row.classifier})) {
    errors.push_back(100 * cell.confidence.calibration_error);
    shares.push_back(100 * cell.confidence.answerable);
    confidence.tells = confidence.tells || cell.confidence.tells;
  }
  confidence.calibration_error = summarise_within(percents, errors);
  confidence.answerable = summarise_within(percents, shares);
  return confidence;
}

std::string confidence_csv(const std::vector<AccuracyRow>& rows, const run::Results& results) {
  std::vector<std::string> header{"dataset", "method", "classifier", "ratio", "seeds"};
  for (const char* quantity : {"calibration_error", "answerable"}) {
    for (const char* field : {"mean", "std", "ci95_low", "ci95_high"}) {
      header.push_back(fmt::format("{}_{}", quantity, field));
    }
  }
  header.emplace_back("tells");
  std::string text = text::csv_line(header);
  for (const AccuracyRow& row : rows) {
    const ConfidenceRow confidence = confidence_of(row, results);
    text += joined_csv_line({{row.dataset, row.method, row.classifier, row.ratio,
                              std::to_string(confidence.answerable.count)},
                             mean_fields(confidence.calibration_error),
                             interval_fields(confidence.calibration_error),
                             mean_fields(confidence.answerable),
                             interval_fields(confidence.answerable),
                             {confidence.tells ? "1" : "0"}});
  }
  return text;
}

std::string confidence_note(const std::vector<std::string>& silent) {
  return fmt::format(
             "Calibration error: how far the score of the class that is named is from how often it "
             "is right, the mean over ten bins of a seed's test windows. Answered: the largest "
             "share of the test windows that may be answered, those with the least score being "
             "refused first, so that at least {} % of the answers are right; 100 where none need "
             "be refused, 0 where no threshold does it. The threshold is read off the same "
             "windows: it says how well the scores rank them, not what a user would get.",
             scoring::wanted_precision_percent) +
         (silent.empty() ? ""
                         : fmt::format(" Nothing is said of how sure the answers of {} are: all "
                                       "windows are answered, or none.",
                                       listed(silent)));
}

std::vector<Section> confidence_sections(const ClassifierRows& block, const run::Results& results) {
  text::Table table({"method", "ratio", "calibration error", "answered", "95 % interval"}, 2);
  std::vector<std::string> silent;
  for (const auto& [name, row] : rows_with_most_windows(block)) {
    const ConfidenceRow confidence = confidence_of(row, results);
    if (!confidence.tells) silent.push_back(name);
    table.row({name, ratio_label(row.ratio, row.true_ratio),
               mean_label(confidence.calibration_error), mean_label(confidence.answerable),
               interval_label(confidence.answerable)});
  }
  const std::string& dataset = block.rows.front().dataset;
  return {PaperReference(dataset, block.classifier)
              .none()
              .of({"confidence",
                   fmt::format("What may be answered at {} % precision on {}, percent",
                               scoring::wanted_precision_percent, dataset),
                   confidence_note(silent), table})};
}

}  // namespace piae::report
