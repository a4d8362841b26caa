#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::scoring {

/// One prediction of a classifier: its certainty, and whether it was correct.
struct Judgement {
  double score = 0;  ///< softmax score of the predicted class, in [0, 1]
  bool right = false;
};

/// Predictions with a score above `from` and up to `to`. The first bin includes 0.
struct ScoreBin {
  double from = 0;
  double to = 0;
  std::size_t count = 0;
  double mean_score = 0;  ///< this and the next are 0 in an empty bin
  double accuracy = 0;    ///< share of correct predictions, in [0, 1]
};

/// Returns the reliability diagram of a classifier: bins of equal width from 0 to 1 (Guo et al.
/// 2017, "On calibration of modern neural networks", Section 2). A score outside [0, 1] counts in
/// the nearest bin.
std::vector<ScoreBin> reliability(std::span<const Judgement> judgements, std::size_t bins);

/// Returns the expected calibration error (their eq. 3): the mean of
/// accuracy - mean score
///  over the bins, weighted by their counts. It is 0 if the accuracy equals the score. Throws
///  std::logic_error if all bins are empty.
double expected_calibration_error(std::span<const ScoreBin> bins);

}  // namespace piae::scoring
