#pragma once

#include <algorithm>
#include <cstddef>

namespace piae::spectra {

/// Returns the block of row `i` of `n`, for `blocks` blocks of equal size. Reference windows that
/// follow each other in time are compared only with windows outside their own block, because
/// overlapping windows would look too similar.
template <class Index>
Index block_of(Index i, Index n, Index blocks) {
  return i * blocks / n;
}

/// Returns the distance above which a window is novel: `margin` times the largest distance of a
/// reference window from those outside its block. Returns at least `least`, for identical reference
/// windows.
inline double left_out_threshold(double largest_left_out, double margin, double least) {
  return std::max(margin * largest_left_out, least);
}

}  // namespace piae::spectra
