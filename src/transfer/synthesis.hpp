#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/random.hpp"
#include "transfer/excitation.hpp"
#include "transfer/path.hpp"

namespace piae::transfer {

/// A window in which the structure is struck: the second half of a frame of two windows, so that
/// what was struck before the window still rings in it. `log_answer` is how the structure answers
/// one blow (structure.hpp), with minimum phase. The mean square is 1, or 0 where
/// nothing is struck, as in windows that are shorter than a period.
Eigen::ArrayXd struck_window(const Eigen::ArrayXd& log_answer, const Path& path,
                             const std::vector<Strike>& strikes, double rate_hz);

/// Noise in which what answers so is excited everywhere at once, with the colour that edges give a
/// struck window: what is not struck in it. The mean square is 1.
Eigen::ArrayXd background_window(const Eigen::ArrayXd& log_answer, const Edges& edges,
                                 double rate_hz, Stream& random);

}  // namespace piae::transfer
