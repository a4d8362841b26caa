#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "raw/signal.hpp"

namespace piae::raw {

/// What the name of a column, or the unit below it, says of times.
struct TimeName {
  bool is_time = false;
  double unit_s = 0;  ///< 0 where none is said
};

/// Reads names such as "Time (s)", "t[ms]", "Zeit/s", "elapsed_us", and units such as "(s)".
TimeName time_name(std::string_view name);

/// Looks at the numbers of a column that holds times, or, where its name does not say so, may hold
/// them; `times.column`, `unit_s` and `is_named` are known. Finds
///   - the usual step: that of nine tenths of the lines, within a quarter of the median. Where the
///     times are uneven, or printed too coarsely for one, a column that is named so has its mean
///     step alone,
///   - gaps: steps of more than 1.5 times the usual one,
///   - steps back. A column that is not named so may have ten; a wheel's angle has more.
/// Returns Times{} for numbers that do not rise as times do.
Times times_in(std::span<const double> numbers, Times times);

/// A sample rate by a column of times.
struct TimesRate {
  double hz = 0;
  double unit_s = 0;  ///< of the times: said by the file, or the likeliest one
};

/// "s", "ms", "us" or "ns".
std::string_view unit_name(double unit_s);

/// The rate by a column of times, where that is not within 1 % of the one given. Nothing where the
/// times do not tell, as a column of whole numbers may count samples.
std::optional<TimesRate> contradicting_rate(const Times& times, double sample_rate_hz);

/// True if the gaps come from rounding: many, and at this rate no sample is missing.
bool are_rounded(const Times& times, double sample_rate_hz);

}  // namespace piae::raw
