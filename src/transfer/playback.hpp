#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace piae::transfer {

/// A window played `factor` times as fast: sample t is the window at start + factor t, to less than
/// one sample. Everything in it moves with the speed, the resonances too, which in a machine stay.
/// It goes on with its beginning where it ends, as with the method `shift`, and is resampled by
/// signal/resample.hpp, so that playing fast folds nothing over. The result is as long as the
/// window. `factor` must be positive and `start` within the window; a factor of 1 turns it round.
std::vector<double> played(std::span<const float> window, std::size_t start, double factor);

}  // namespace piae::transfer
