#pragma once

#include <array>
#include <vector>

#include "spectra/order_spectrum.hpp"
#include "spectra/power.hpp"

/// Three measures of how far a fault's line and its harmonics stand out of an envelope spectrum.
/// They deliberately differ in what they leave free:
///
/// - free_harmonics_db(): each harmonic lies anywhere within 2 % of its place. Use it for mean
/// spectra of many windows of one class, at speeds that differ a little.
/// - common_line(): the harmonics belong to one frequency within 2 % of its place. Use it for one
/// recording, where a foreign line near one harmonic must count for little.
/// - common_slip_height(): the harmonics share one slip of up to 1.2 %, over a floor that is a
/// running median. Use it for one window of some turns of the shaft.
namespace piae::spectra {

/// Number of harmonics that free_harmonics_db() and common_line() use: 1, 2 and 3 times the line.
inline constexpr int line_harmonics = 3;
/// Relative distance from its place within which a line is searched. It allows for usual slip and
/// for a speed that differs slightly from the nominal speed.
inline constexpr double line_tolerance = 0.02;

/// Mean power of the windows' envelopes, each tapered by Hann's window and padded to four times its
/// length.
struct EnvelopeSpectrum {
  std::vector<double> power;  ///< by bin, from 0 Hz
  double bin_hz = 0;
  double resolution_hz = 0;  ///< one over the length of a window
  double averages = 0;       ///< number of independent windows with the same scatter (Welch 1967)
  double rounding = 0;       ///< a power below this is rounding alone
};

/// Returns the envelope spectrum of independent windows. Throws std::logic_error if `windows` is
/// empty.
EnvelopeSpectrum envelope_spectrum(const Windows& windows, double rate_hz);

/// Returns how far the line and its second and third harmonic stand out, in dB: the mean over the
/// three of 10 log10(line / floor). The line is the highest bin within 2 % of its place. The floor
/// is the median power on both sides, half way to the next harmonics.
///
/// Sets of 45 real windows of one CWRU class differ by 0.1 to 0.6 dB (standard deviation). White
/// noise gives about 0. A negative value means that a foreign line raises the floor. A harmonic
/// counts as 0 if it cannot be separated from its neighbours: if the windows hold fewer than about
/// five periods of the line, the line is at 0 Hz, or it lies beyond half the sampling rate. Silence
/// also counts as 0.
double free_harmonics_db(const EnvelopeSpectrum& spectrum, double line_hz);

/// Three harmonics of one frequency.
struct CommonLine {
  double hz = 0;
  std::array<double, line_harmonics> decibels{};  ///< 10 log10(line / floor) of each harmonic

  [[nodiscard]] double mean_db() const;
};

/// True if a line at this frequency can be separated from its surroundings.
bool can_measure_common_line(const EnvelopeSpectrum& spectrum, double line_hz);

/// Returns the frequency within 2 % of `line_hz` at which the mean over three harmonics is highest.
/// Floors are those of free_harmonics_db(). Requires can_measure_common_line().
CommonLine common_line(const EnvelopeSpectrum& spectrum, double line_hz);

/// Largest slip of common_slip_height(), in either direction.
inline constexpr double largest_slip = 0.012;

/// Returns the height of a line whose order without slip is `order`: the mean of the heights at its
/// harmonics 1 .. `count`, clipped to `lowest` .. 2.5. All harmonics share one slip of up to 1.2 %
/// in either direction, in steps of 0.1 %; the slip with the largest mean counts (Randall and
/// Antoni 2011: bearings slip by 1 to 2 %). Foreign lines rarely fit a common slip.
double common_slip_height(const OrderSpectrum& spectrum, double order, int count, double lowest);

}  // namespace piae::spectra
