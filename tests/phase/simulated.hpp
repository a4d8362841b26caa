#pragma once

#include <string>
#include <vector>

#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "signal/window_set.hpp"

namespace piae::phase {

/// A 6205 at 12 kHz and 1797 rpm: healthy, inner race and outer race.
inline signal::DatasetInfo bearing_info() {
  signal::DatasetInfo info;
  info.name = "example";
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1797;
  info.classes = {{"Normal", signal::Defect::none, 0},
                  {"IR021", signal::Defect::inner, 0.5334},
                  {"OR021", signal::Defect::outer, 0.5334}};
  return info;
}

/// Acceleration by eq. 13 with the outer race's defect and without slip, so that strikes are
/// strictly periodic; white noise `snr_db` below it.
inline std::vector<double> outer_race_signal(std::size_t samples, double snr_db, Stream noise) {
  const signal::DatasetInfo info = bearing_info();
  bearing::Motion motion;
  motion.shaft_speed_rpm = info.shaft_speed_rpm;
  std::vector<double> signal = bearing::simulate(info.bearing, {signal::Defect::outer, 0.5334},
                                                 motion, {}, {info.sample_rate_hz, samples});
  double power = 0;
  for (const double x : signal) power += x * x / static_cast<double>(samples);
  for (double& x : signal) x += noise.normal(0, std::sqrt(power * std::pow(10, -snr_db / 10)));
  return signal;
}

/// Five known windows of each faulty class, by eq. 13 with (k, c) drawn around those given.
inline signal::WindowSet simulated_windows(std::size_t count, const std::string& stream_name,
                                           double snr_db = 10) {
  signal::WindowSet windows;
  windows.info = bearing_info();
  windows.length = 1024;
  for (const int label : {1, 2}) {
    const signal::ClassInfo& c = windows.info.classes[static_cast<std::size_t>(label)];
    for (std::size_t i = 0; i < count; ++i) {
      Stream stream = Stream(stream_name).child(c.name).child(std::to_string(i));
      bearing::DynamicsOptions dynamics;
      dynamics.stiffness_n_per_m *= stream.uniform(0.8, 1.2);
      dynamics.damping_ns_per_m *= stream.uniform(0.6, 1.4);
      bearing::Motion motion;
      motion.shaft_speed_rpm = windows.info.shaft_speed_rpm;
      motion.cage_angle_rad = stream.uniform(0, 6.28);
      if (label == 1) motion.defect_angle_rad = stream.uniform(0, 6.28);
      const std::vector<double> clean =
          bearing::simulate(windows.info.bearing, {c.defect, c.defect_size_mm}, motion, dynamics,
                            {windows.info.sample_rate_hz, windows.length});
      double power = 0;
      for (const double x : clean) power += x * x / static_cast<double>(clean.size());
      const double deviation = std::sqrt(power * std::pow(10, -snr_db / 10));
      for (const double x : clean) {
        windows.samples.push_back(static_cast<float>(x + stream.normal(0, deviation)));
      }
      windows.labels.push_back(label);
      windows.parameters.push_back({dynamics.stiffness_n_per_m, dynamics.damping_ns_per_m});
    }
  }
  return windows;
}

}  // namespace piae::phase
