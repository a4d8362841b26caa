#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "signal/cycle.hpp"
#include "transfer/comb.hpp"
#include "transfer/cutting.hpp"

namespace piae::transfer {

/// A window as a cycle without end.
struct Turning {
  std::vector<double> samples;  ///< from a strike on
  signal::Cycle cycle;
  bool has_rhythm = true;  ///< false where not one whole period fits into the window
};

/// A window of which as many whole strikes as fit are a cycle: those of the loudest stretch of it.
/// Where not one fits, the window is its own cycle, and has a seam.
Turning turning_of(std::span<const double> window, const Comb& comb);

/// A window of `length` samples that begins anywhere in the first and from a random moment on goes
/// on in the second, at the same part of the period between strikes, to half a sample
/// (signal/passage.hpp). Where one has no rhythm, nothing is known of strikes.
StruckWindow turned(const Turning& first, const Turning& second, std::size_t length,
                    Stream& random);

}  // namespace piae::transfer
