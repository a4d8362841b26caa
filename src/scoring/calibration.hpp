#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::scoring {

/// One prediction of a classifier: how sure it was, and whether it was right.
struct Judgement {
  double score = 0;  ///< the softmax score of the class that it named, in [0, 1]
  bool right = false;
};

/// The predictions whose score lies above `from` and up to `to`. The first bin has 0, too.
struct ScoreBin {
  double from = 0;
  double to = 0;
  std::size_t count = 0;
  double mean_score = 0;  ///< this and the next are 0 in an empty bin
  double accuracy = 0;    ///< share of the predictions that are right, in [0, 1]
};

/// The reliability diagram of a classifier: bins of equal width from 0 to 1 (Guo et al. 2017, "On
/// calibration of modern neural networks", Section 2). A score outside of [0, 1] counts in the bin
/// that is nearest.
std::vector<ScoreBin> reliability(std::span<const Judgement> judgements, std::size_t bins);

/// The expected calibration error (their eq. 3): the mean of |accuracy - mean score| over the bins,
/// weighted by their counts. 0 for a classifier that is right as often as it says. Throws
/// std::logic_error where all bins are empty.
double expected_calibration_error(std::span<const ScoreBin> bins);

}  // namespace piae::scoring
