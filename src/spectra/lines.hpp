#pragma once

#include <array>
#include <vector>

#include "spectra/order_spectrum.hpp"
#include "spectra/power.hpp"

/// Three measures of how far a fault's line and its harmonics stand out of an envelope spectrum.
/// They differ in what they leave free, on purpose:
///
/// - free_harmonics_db(): each harmonic lies anywhere within 2 % of its place. For mean spectra of
/// many
///   windows of one class, at speeds that differ a little.
/// - common_line(): the harmonics belong to one frequency within 2 % of its place. For one
/// recording, in
///   which a line of something else near one of them must count for little.
/// - common_slip_height(): the harmonics have one slip of up to 1.2 %, over a floor that is a
/// running
///   median. For one window of some turns of the shaft.
namespace piae::spectra {

/// How many harmonics of a line free_harmonics_db() and common_line() take: itself, twice, three
/// times.
inline constexpr int line_harmonics = 3;
/// The part of its place within which a line is sought: usual slip, and a speed that is not quite
/// the nominal one.
inline constexpr double line_tolerance = 0.02;

/// Mean power of the windows' envelopes, each tapered by Hann's window and padded to four times its
/// length.
struct EnvelopeSpectrum {
  std::vector<double> power;  ///< by bin, from 0 Hz on
  double bin_hz = 0;
  double resolution_hz = 0;  ///< one over the length of a window
  double averages = 0;       ///< as many independent windows would scatter as little (Welch 1967)
  double rounding = 0;       ///< a power below this is rounding alone
};

/// Returns the envelope spectrum of independent windows. Throws std::logic_error if there is none.
EnvelopeSpectrum envelope_spectrum(const Windows& windows, double rate_hz);

/// Returns how far the line and its second and third harmonic stand out, in dB: the mean over the
/// three of 10 log10(line / floor). The line is the highest bin within 2 % of its place; the floor
/// is the median power next to it, half way to the next harmonics on either side.
///
/// Sets of 45 real windows of one CWRU class differ by 0.1 to 0.6 dB (standard deviation). White
/// noise has about 0. A negative value means that the line of something else raises the floor. A
/// harmonic counts as 0 where it cannot be told from its neighbours: the windows hold less than
/// some five periods of the line, there is no line (0 Hz), or it lies beyond half the sampling
/// rate. Silence counts as 0 too.
double free_harmonics_db(const EnvelopeSpectrum& spectrum, double line_hz);

/// Three harmonics of one frequency.
struct CommonLine {
  double hz = 0;
  std::array<double, line_harmonics> decibels{};  ///< of each harmonic, 10 log10(line / floor)

  [[nodiscard]] double mean_db() const;
};

/// True if a line at this frequency can be told from what lies next to it.
bool can_measure_common_line(const EnvelopeSpectrum& spectrum, double line_hz);

/// Returns the one frequency within 2 % of `line_hz` at which the mean over three harmonics is
/// highest. Floors are those of free_harmonics_db(). can_measure_common_line() must be true.
CommonLine common_line(const EnvelopeSpectrum& spectrum, double line_hz);

/// The largest slip of common_slip_height(), either way.
inline constexpr double largest_slip = 0.012;

/// Returns the height of a line that stands at `order` without slip: the mean over its harmonics 1
/// .. `count` of the heights in the spectrum, clipped to `lowest` .. 2.5, at the one slip of up to
/// 1.2 % either way, in steps of 0.1 %, at which that mean is greatest (Randall and Antoni 2011:
/// bearings slip by 1 to 2 %). A common slip, since lines of something else near one of them
/// rarely are in tune.
double common_slip_height(const OrderSpectrum& spectrum, double order, int count, double lowest);

}  // namespace piae::spectra
