#pragma once

#include <span>

#include "scoring/statistics.hpp"

namespace piae::report {

/// Between what a quantity lies, whatever is measured.
struct Bounds {
  double low;
  double high;
};

inline constexpr Bounds percents{0, 100};
/// Of two percents, in points.
inline constexpr Bounds differences_of_percents{-100, 100};

/// Leaves of the interval what can be shown to people.
///
/// It ends at the bounds. The true mean lies between them, so what is cut off never held it, and
/// the interval holds it as often as before. Of fewer than three values there is no interval: of
/// two, Student's t gives one of nine standard deviations to either side, which says nothing.
void bound(scoring::Summary& summary, const Bounds& bounds);

/// scoring::summarise() with such an interval.
scoring::Summary summarise_within(const Bounds& bounds, std::span<const double> values);

/// What tables for people say of these intervals.
inline constexpr const char* about_intervals =
    "95 % is the interval of the mean by Student's t, cut off where no mean can lie; there is none "
    "of fewer than three seeds, of which it would span nearly all that can be.";

}  // namespace piae::report
