#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "base/random.hpp"
#include "impacts/edges.hpp"
#include "impacts/times.hpp"

namespace piae::impacts {

/// Returns the spectrum of impacts at `bins` frequencies, `bin_hz` apart from 0 Hz on:
///   X(f) = sum of strength exp(-2 pi i f time) (1 - exit exp(-2 pi i f lag)).
Eigen::ArrayXcd excitation(const std::vector<Impact>& impacts, Eigen::Index bins, double bin_hz);

/// Returns the samples of a frame in which impacts excite a structure of this response
/// (response.hpp).
Eigen::ArrayXd impact_frame(const std::vector<Impact>& impacts, const Eigen::ArrayXcd& response,
                            double rate_hz);

/// Returns the last `length` samples of a frame, in which impacts before the window still ring. The
/// mean square is 1, or 0 without impacts, as in windows shorter than a period.
Eigen::ArrayXd window_of(const Eigen::ArrayXd& frame, std::size_t length);

/// Returns noise with the spectrum of a response and of both edges: the part of a window that
/// impacts do not excite. Its length is half a frame and its mean square 1.
Eigen::ArrayXd noise_window(const Eigen::ArrayXd& log_response, const Edges& edges, double rate_hz,
                            Stream& random);

}  // namespace piae::impacts
