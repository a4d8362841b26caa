#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "base/random.hpp"
#include "signal/dataset_info.hpp"

namespace piae::machines {

/// Samples of a window, and least number of shaft turns in it.
inline constexpr std::size_t window_length = 4096;
inline constexpr double least_turns = 2.3;

/// Returns the classes healthy, inner, ball and outer.
std::vector<signal::ClassInfo> fault_type_classes();

/// A healthy machine that does not exist. Its bearing, speed, sample rate, structure, noise and
/// tones are random (draw_machine()).
struct Machine {
  /// A sine in the signal: a harmonic of the shaft, gears, blades.
  struct Tone {
    double hz = 0;
    double amplitude = 0;
    bool of_shaft = false;  ///< false: its amplitude varies with the shaft's angle
  };

  signal::DatasetInfo info;            ///< with the classes healthy, inner, ball and outer
  std::size_t length = window_length;  ///< samples of a window
  /// [length + 1] logarithm of the amplitude of the noise at the sensor, at the bins of a frame of
  /// two windows; its mean is 0.
  Eigen::ArrayXd log_amplitude;
  std::vector<Tone> tones;
  double tone_power = 0;    ///< mean square of all tones / that of the noise
  double sensor_noise = 0;  ///< standard deviation of white noise / that of the noise
  /// Modulation depths of the noise at BPFO, BPFI, 2 BSF and the shaft's speed. Healthy bearings
  /// have lines, too, from waviness, load and unbalance.
  std::array<double, 4> modulation{};
  double stray_impacts = 0;  ///< mean number of impacts in a frame that do not come from a defect
  double window_db = 0;      ///< standard deviation of the path's gain at a knot between windows
  double day_db = 0;         ///< the same between two days: another load, temperature or mounting
};

/// Draws a machine. The ranges cover laboratory rigs and small industrial machines:
///  - 6 to 16 balls whose diameter is 0.13 to 0.32 of the pitch diameter, so that any two fault
///    lines can be told apart in a window;
///  - 10 to 26 kHz and 2.3 to 15 turns of the shaft in a window, so 340 to 5700 rpm;
///  - a structure like that of piae-dt-zero (zero/structure.hpp);
///  - up to 11 harmonics of the shaft and 3 other tones, at -20 to 10 dB of the noise;
///  - sensor noise at -30 to -5 dB; modulation up to 0.3; paths that vary by 0.1 to 1 dB between
///    windows, and by up to 3 dB between days.
Machine draw_machine(const Stream& stream);

}  // namespace piae::machines
