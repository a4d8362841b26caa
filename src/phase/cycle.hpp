#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "signal/dataset_info.hpp"

namespace piae::phase {

/// How often the defect of a class strikes, in Hz: BPFO, BPFI, or 2 BSF for a ball, which strikes
/// both races in one turn. Throws Error(bad_input) for a class without a defect.
double strike_frequency_hz(const signal::DatasetInfo& info, std::size_t label);

/// The fault cycle of a class in samples: as many whole strikes as fit into a window and leave some
/// of it over to blend its end into its beginning. One sample stands for 2 pi m / L of the strike
/// angle; L is rounded to whole samples, 0.05 % of 1024 and far below what slip does.
struct Cycle {
  std::size_t samples = 0;  ///< L
  std::size_t strikes = 0;  ///< m, in L samples
  std::size_t blend = 0;    ///< samples over which the end goes over into the beginning

  /// Samples from one strike to the j-th after it, rounded.
  [[nodiscard]] std::size_t offset_of_strike(std::size_t j) const;
  /// Strike angle in [0, 2 pi) of a sample of the cycle.
  [[nodiscard]] double angle_rad(std::size_t sample) const;
};

/// For windows of `length` samples. Throws Error(bad_input) where less than one strike fits.
Cycle cycle_of(const signal::DatasetInfo& info, std::size_t label, std::size_t length);

/// One cycle of a window, [L]: its first L samples, the first few blended with what follows the
/// L-th.
std::vector<double> closed_cycle(std::span<const double> window, const Cycle& cycle);

/// `count` samples of a cyclic waveform from sample `start` on. Shifting the start shifts the
/// result by as many samples, bit for bit.
template <class T>
std::vector<T> read(std::span<const T> waveform, std::size_t start, std::size_t count) {
  std::vector<T> samples(count);
  for (std::size_t i = 0; i < count; ++i) samples[i] = waveform[(start + i) % waveform.size()];
  return samples;
}

}  // namespace piae::phase
