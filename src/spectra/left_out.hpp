#pragma once

#include <algorithm>
#include <cstddef>

namespace piae::spectra {

/// Reference windows that follow each other in time are compared with those outside their own
/// block, because windows that overlap would vouch for each other. Returns the block of row `i` of
/// `n`, of `blocks` of equal size.
template <class Index>
Index block_of(Index i, Index n, Index blocks) {
  return i * blocks / n;
}

/// Returns the distance above which a window is new: `margin` times the largest distance of a
/// reference window to those outside its block, or `least` where all reference windows are alike.
inline double left_out_threshold(double largest_left_out, double margin, double least) {
  return std::max(margin * largest_left_out, least);
}

}  // namespace piae::spectra
