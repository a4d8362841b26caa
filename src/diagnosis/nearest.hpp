#pragma once

#include <cstddef>
#include <vector>

#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// The class of each test window by its nearest neighbour among the training windows: no training,
/// and the bar that a generator must clear to be worth its name. Windows are compared by the
/// logarithm of their power in 128 bands of equal width, from which its mean over the bands is
/// removed, so that neither the level nor the angle at which a window starts counts; the distance
/// is Euclid's. Of equal distances the first training window counts. Throws Error(bad_input) where
/// windows are shorter than 256 samples or of another length than those of the test.
std::vector<Label> classify_by_nearest(const signal::WindowSet& training,
                                       const signal::WindowSet& test);

/// What it says of all classes, row-major [n, classes]: 1 for the named one and 0 for the others,
/// since a neighbour does not say how sure it is.
std::vector<float> scores_of_named(const std::vector<Label>& named, std::size_t classes);

}  // namespace piae::diagnosis
