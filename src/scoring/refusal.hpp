#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scoring/calibration.hpp"

namespace piae::scoring {

// A classifier with a reject option: windows whose largest score is too small get no prediction
// (Geifman and El-Yaniv 2017, "Selective classification for deep neural networks": the share with a
// prediction is their coverage, and one minus the precision their selective risk). All thresholds
// are chosen on the tested windows themselves. So the results show how well the scores rank
// windows, not what a user achieves who must choose the threshold in advance.

/// Returns the largest share of the windows that may get a prediction so that at least
/// `precision_percent` of a hundred predictions are correct; windows with the least score are
/// refused first. In [0, 1]: 1 if no window must be refused, 0 if no threshold suffices. Windows of
/// one score are treated alike. Throws std::logic_error without judgements.
double answerable_share(std::span<const Judgement> judgements, std::size_t precision_percent);

/// Returns the share of correct predictions, in [0, 1], when 1, 2, ..., `steps` of `steps` equal
/// parts of the windows get a prediction, largest score first. If a part ends within windows of the
/// same score, their average precision counts. Throws std::logic_error without judgements or steps.
std::vector<double> precision_by_share(std::span<const Judgement> judgements, std::size_t steps);

}  // namespace piae::scoring
