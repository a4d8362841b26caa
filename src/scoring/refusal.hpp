#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scoring/calibration.hpp"

namespace piae::scoring {

// A classifier with a reject option: windows whose largest score is too small get no answer
// (Geifman and El-Yaniv 2017, "Selective classification for deep neural networks": the share that
// is answered is the coverage there, and one minus the precision the selective risk). All that is
// read off the windows that are answered, so it says how well the scores rank them, and not what a
// user would get who has to choose the threshold before.

/// The largest share of the windows that may be answered so that at least `precision_percent` of a
/// hundred answers are right, where those with the least score are refused first; in [0, 1]. 1
/// where nothing need be refused, 0 where no threshold does it. Windows of one score are answered
/// together or not at all. Throws std::logic_error where there is no judgement.
double answerable_share(std::span<const Judgement> judgements, std::size_t precision_percent);

/// The share of right ones among the answered, in [0, 1], where 1, 2, ..., `steps` of `steps` equal
/// parts of the windows are answered, those with the largest score first. Of windows with the same
/// score that are answered in part, as many count as right as would on average. Throws
/// std::logic_error where there is no judgement or no step.
std::vector<double> precision_by_share(std::span<const Judgement> judgements, std::size_t steps);

}  // namespace piae::scoring
