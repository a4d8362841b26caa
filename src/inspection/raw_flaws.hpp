#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

// What only the samples of the file show: after resampling, flat tops and stretches of one value
// are rounded. The signal must not be constant.

/// Stretches in which a signal keeps one value.
struct Stretches {
  std::size_t count = 0;
  std::size_t samples = 0;        ///< in all of them
  std::size_t longest = 0;        ///< samples
  std::size_t longest_first = 0;  ///< its first sample, counted from 0
  double value = 0;               ///< of the longest
};

/// Whether the samples only rise or only fall, but for one step in a thousand: a time, a counter or
/// an angle. A vibration turns round at every pass of a ball; of 20 steps, which there must be,
/// noise goes one way in one of 20! cases.
bool goes_one_way(std::span<const double> samples);

/// The smallest distance of two values: the resolution of the converter.
double quantum_of(std::span<const double> samples);

/// Peaks that are cut off at the highest or lowest value of the record. A parabola, which every
/// smooth peak is, that is rounded to m equal samples has left them by at most ((m + 1) / (m -
/// 1))^2 quanta one sample later, and rounding adds one. A stretch that is left or entered by more
/// was cut. Two samples may meet by chance, so nothing is returned for less than three in all.
Stretches clipped_peaks(std::span<const double> samples);

/// Stretches at any other value that are too long for chance and too abrupt for a slow signal. Too
/// long: if samples repeat their predecessor as often as they do in this record, but independently,
/// then one record in a thousand has such a stretch. Too abrupt: as with clipped peaks. A stretch
/// below ten samples, one percent of a window, is left out: it does no harm.
Stretches held_values(std::span<const double> samples);

}  // namespace piae::inspection
