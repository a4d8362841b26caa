#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace piae::signal {

/// The fault cycle of a window, in samples: as many whole strikes as fit into it, less a part of
/// the window that is needed to blend the cycle's end into its beginning. From one sample to the
/// next the strike angle grows by 2 pi m / L. L is rounded to whole samples; at 1024 samples that
/// is an error of 0.05 %, far below that of slip.
struct Cycle {
  std::size_t samples = 0;  ///< L
  std::size_t strikes = 0;  ///< m, the strikes in L samples
  std::size_t blend = 0;    ///< samples over which the end is blended into the beginning

  /// Samples from one strike to the j-th after it, rounded.
  [[nodiscard]] std::size_t offset_of_strike(std::size_t j) const;
  /// The strike angle of a sample of the cycle, in [0, 2 pi).
  [[nodiscard]] double angle_rad(std::size_t sample) const;
  /// Samples from strike to strike.
  [[nodiscard]] double period() const;
};

/// The cycle of windows of `length` samples with a strike every `period` samples. None where not
/// one whole strike fits.
std::optional<Cycle> cycle_of(double period, std::size_t length);

/// One cycle of a window, [L]: its first L samples, of which the first few are blended with the
/// samples that follow the L-th, so that the cycle has no jump where its end meets its beginning.
std::vector<double> closed_cycle(std::span<const double> window, const Cycle& cycle);

/// `count` samples of a cyclic waveform from sample `start` on. A start that is j samples later
/// gives the same result shifted by j samples, bit for bit.
template <class T>
std::vector<T> read(std::span<const T> waveform, std::size_t start, std::size_t count) {
  std::vector<T> samples(count);
  for (std::size_t i = 0; i < count; ++i) samples[i] = waveform[(start + i) % waveform.size()];
  return samples;
}

}  // namespace piae::signal
