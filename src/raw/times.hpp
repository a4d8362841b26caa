#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "raw/signal.hpp"

namespace piae::raw {

/// Information on times from a column's name or the unit below it.
struct TimeName {
  bool is_time = false;
  double unit_s = 0;  ///< 0 if there is none
};

/// Reads names such as "Time (s)", "t[ms]", "Zeit/s", "elapsed_us", and units such as "(s)".
TimeName time_name(std::string_view name);

/// Analyses the numbers of a column that holds times, or may hold times if its name does not say
/// so. The caller sets `times.column`, `unit_s` and `is_named`. Finds
///   - the usual step: the step of nine tenths of the lines, within a quarter of the median. If a
///     named column is uneven, or printed too coarsely for a usual step, finds the mean step only,
///   - gaps: steps of more than 1.5 times the usual one,
///   - steps back. An unnamed column may have ten; a wheel's angle has more.
/// Returns Times{} for numbers that do not rise like times.
Times times_in(std::span<const double> numbers, Times times);

/// A sample rate from a column of times.
struct TimesRate {
  double hz = 0;
  double unit_s = 0;  ///< declared or likeliest unit of the times
};

/// Returns "s", "ms", "us" or "ns".
std::string_view unit_name(double unit_s);

/// Returns the rate from a column of times if it is not within 1 % of the given one. Returns
/// nothing if the times are ambiguous: a column of integers may count samples.
std::optional<TimesRate> contradicting_rate(const Times& times, double sample_rate_hz);

/// True if the gaps come from rounding: there are many, and at this rate no sample is missing.
bool are_rounded(const Times& times, double sample_rate_hz);

}  // namespace piae::raw
