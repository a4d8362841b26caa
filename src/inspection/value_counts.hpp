#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace piae::inspection {

// Flaws visible in how often a record takes each value. All functions need the file's own samples,
// because resampling rounds them.

/// Returns the number of distinct values if it is at most 16; nothing if there are more. Such a
/// record uses 4 bits of a converter with 12 or more. At a crest factor of 4, usual for vibration,
/// its RMS is 1.9 steps or less. Then rounding makes up more than 2 % of its power, and an impact
/// below a sixteenth of the range leaves no trace. Returns nothing for fewer than ten samples per
/// value, because the record is too short to judge.
std::optional<std::size_t> few_values(std::span<const double> samples);

/// Samples exactly on the highest or lowest value of a record.
struct CutTops {
  std::size_t on_highest = 0;  ///< 0 if the count can be natural
  std::size_t on_lowest = 0;
  double highest = 0;
  double lowest = 0;

  [[nodiscard]] std::size_t samples() const { return on_highest + on_lowest; }
};

/// Finds clipped peaks, even if each flat top is a single sample: a clipped signal visits its
/// extreme value more often than an unclipped one.
///
/// A smooth peak is a parabola, so the time within d of its top grows as sqrt(d). If all peaks are
/// equally high, as in a sine at full scale, the share of samples within d of the extreme also
/// grows as sqrt(d). If peaks differ, as in noise and impacts, the share grows faster. So of all
/// visits to the extreme value and the next four values, at most sqrt(q / w) are at the extreme: q
/// is the converter's step, and w the width of these five values. In a clipped signal all visits
/// beyond the limit are at the extreme.
///
/// Two tests, each with Chernoff's bound of the binomial distribution and both ends of the record
/// together, show that the share is exceeded:
///   - on adjacent values, with 1 / sqrt(5), the bound at its loosest;
///   - with the bound itself, but without the first visit, which defines the extreme. Visits are
///     divided by the median visits of the four other values, because a signal that repeats itself
///     exactly, such as a computed sine, visits all of its values this often.
/// One record in a thousand exceeds either by chance.
CutTops cut_tops(std::span<const double> samples);

}  // namespace piae::inspection
