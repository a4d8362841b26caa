#include "classification/verdict.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "inspection/spectrum_panel.hpp"

namespace piae::classification {

namespace {

/// Returns [classes] the mean probabilities over the known windows, or over all if all are unknown.
Eigen::VectorXd mean_probabilities(const Verdict& verdict, std::size_t classes) {
  const bool all = verdict.share_unknown == 1;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(classes));
  double count = 0;
  for (std::size_t i = 0; i < verdict.start_s.size(); ++i) {
    if (!all && verdict.is_unknown(i)) continue;
    sum += Eigen::Map<const Eigen::VectorXf>(verdict.predictions.probabilities.data() + i * classes,
                                             sum.size())
               .cast<double>();
    ++count;
  }
  return sum / count;
}

}  // namespace

Verdict judge(Recording recording, diagnosis::KeptClassifier& classifier, std::size_t step) {
  const signal::DatasetInfo& info = classifier.info();
  const signal::WindowSet windows = windows_of(recording, info, classifier.length(), step);
  Verdict verdict;
  verdict.predictions = classifier.predict(windows);
  verdict.can_refuse = classifier.novelty().has_value();
  for (const std::int64_t first : windows.first_sample) {
    verdict.start_s.push_back(static_cast<double>(first) / info.sample_rate_hz);
  }
  const auto n = static_cast<double>(windows.size());
  verdict.share_unknown = static_cast<double>(std::ranges::count_if(
                              verdict.predictions.novelty,
                              [](double s) { return s > diagnosis::highest_known_novelty; })) /
                          n;
  verdict.unknown = verdict.share_unknown > 0.5;
  Eigen::Index named = 0;
  verdict.probability = mean_probabilities(verdict, info.classes.size()).maxCoeff(&named);
  verdict.label = static_cast<Label>(named);
  verdict.share =
      static_cast<double>(std::ranges::count(verdict.predictions.labels, verdict.label)) / n;
  verdict.envelope =
      inspection::envelope_spectrum(signal_for_lines(recording, info.sample_rate_hz),
                                    info.sample_rate_hz, recording.shaft_speed_rpm / 60);
  verdict.lines = inspection::fault_lines(verdict.envelope, info, recording.shaft_speed_rpm);
  inspection::keep_shown_part(verdict.envelope, verdict.lines, recording.shaft_speed_rpm / 60);
  verdict.recording = std::move(recording);
  return verdict;
}

}  // namespace piae::classification
