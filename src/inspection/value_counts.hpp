#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace piae::inspection {

// Flaws that show in how often a record takes each of its values. All functions take the samples
// of the file, since resampling rounds them.

/// Returns the number of distinct values where there are at most 16, and nothing where there are
/// more. Such a record uses 4 bits of a converter that has 12 or more: at a crest factor of 4,
/// usual for vibration, its RMS is 1.9 steps or less, so rounding alone makes up more than 2 % of
/// its power, and an impact below a sixteenth of the range leaves no trace. A record of fewer than
/// ten samples for each value is too short to tell.
std::optional<std::size_t> few_values(std::span<const double> samples);

/// Samples that lie exactly on the highest or lowest value of a record.
struct CutTops {
  std::size_t on_highest = 0;  ///< 0 where as many can lie there by nature
  std::size_t on_lowest = 0;
  double highest = 0;
  double lowest = 0;

  [[nodiscard]] std::size_t samples() const { return on_highest + on_lowest; }
};

/// Finds peaks that are cut off, even where each flat top is a single sample: the signal visits its
/// extreme value more often than one that turns round by itself.
///
/// A smooth peak is a parabola, so the time that it spends within d of its top grows as sqrt(d).
/// Where all peaks are equally high, as those of a sine at full scale, the share of samples within
/// d of the extreme grows so, too. Where peaks differ, as in noise and impacts, it grows faster. So
/// of the visits to the extreme value and to the next four, at most sqrt(q / w) are to the extreme:
/// q is the step of the converter, and w the width of these five values, the extreme included. A
/// clipped signal has all visits there that would have gone beyond.
///
/// Two tests show that the share is exceeded, each with Chernoff's bound of the binomial
/// distribution, both ends of the record together:
///   - on adjacent values, with 1 / sqrt(5), which is the bound at its loosest;
///   - with the bound itself, but without the first visit, which defines the extreme, and over the
///     median visits of the four other values, since a signal that repeats itself exactly, as a
///     computed sine does, visits all of its values so often.
/// One record in a thousand exceeds either by chance.
CutTops cut_tops(std::span<const double> samples);

}  // namespace piae::inspection
