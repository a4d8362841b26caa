#pragma once

#include <optional>
#include <span>

namespace piae::spectra {

/// Speed of a shaft, estimated from its vibration.
struct ShaftSpeed {
  double rpm = 0;
  /// Distance of the best speed from the second best, which differs by more than 0.5 %, in standard
  /// deviations over all speeds of the search. 0 at 3000 and 3600 rpm, where hum of the mains
  /// (mains.hpp) looks the same.
  double confidence = 0;

  /// True if the shaft shows: the second best is at least 2.5 deviations worse, which white noise
  /// reaches in one record of 100.
  [[nodiscard]] bool is_certain() const { return confidence >= 2.5; }
  /// True if it is certain and within so many percent of the given speed.
  [[nodiscard]] bool is_within(double percent, double given_rpm) const;
};

/// Range of the search about the given speed: nominal speeds are rarely wrong by more, and beyond
/// it harmonics of one speed are taken for neighbouring harmonics of another.
inline constexpr double speed_search_percent = 10;

/// Estimates the speed of the shaft within 10 % of a given one. Shafts and what
/// turns with them make harmonics of the speed in the spectrum (unbalance, misalignment, looseness:
/// ISO 13373-2) and modulate impacts, so in the envelope spectrum, too. Let L be a spectrum in dB
/// above its running median over half the speed, clipped to 0 .. 15 dB, so that no single line
/// decides. For each speed f of the search
///
///     a(f) = mean of L of the signal at f, 2 f, ..., 20 f
///     b(f) = mean of L of the whole band's envelope (whole_band_envelope.hpp) at f ... 8 f,
///
/// each without the multiples of that prime which leave the least: impacts at an order of 3.6 make
/// lines at 4 f, 8 f, ... of a speed that is 10 % lower. The estimate maximises the sum of both,
/// each over its standard deviation in the search. Harmonics above half the sample rate do not
/// count. Uses 2^19 samples at most, from the start. Empty for fewer than 20 turns, for a constant
/// signal, and if the sample rate holds fewer than three harmonics.
std::optional<ShaftSpeed> estimate_shaft_speed(std::span<const double> signal, double rate_hz,
                                               double given_rpm);

}  // namespace piae::spectra
