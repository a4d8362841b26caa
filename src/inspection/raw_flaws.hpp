#pragma once

#include <cstddef>
#include <span>

namespace piae::inspection {

// Flaws that only the file's own samples show, because resampling rounds flat tops and stretches of
// one value. The signal must not be constant.

/// Stretches of one value.
struct Stretches {
  std::size_t count = 0;
  std::size_t samples = 0;        ///< in all of them
  std::size_t longest = 0;        ///< samples
  std::size_t longest_first = 0;  ///< its first sample, counted from 0
  double value = 0;               ///< of the longest
};

/// True if the samples only rise or only fall, except for one step in a thousand: a time, a counter
/// or an angle. A vibration changes direction at every passing ball. The record must have 20 steps;
/// noise goes one way over 20 steps in one of 20! cases.
bool goes_one_way(std::span<const double> samples);

/// Returns the smallest difference of two values: the resolution of the converter.
double quantum_of(std::span<const double> samples);

/// Returns peaks cut off at the highest or lowest value of the record. Every smooth peak is a
/// parabola. Rounded to m equal samples, it changes by at most ((m + 1) / (m - 1))^2 quanta in the
/// next sample, and rounding adds one. A larger step into or out of the stretch proves a cut.
/// Returns nothing for fewer than three samples in all, because two may agree by chance.
Stretches clipped_peaks(std::span<const double> samples);

/// Returns stretches at other values that are too long for chance and too abrupt for a slow signal.
/// Too long: samples that repeat their predecessor as often as in this record, but independently,
/// have such a stretch in one record in a thousand. Too abrupt: as with clipped peaks. Ignores
/// stretches below ten samples, one percent of a window, because they do no harm.
Stretches held_values(std::span<const double> samples);

}  // namespace piae::inspection
