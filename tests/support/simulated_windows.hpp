#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "bearing/kinematics.hpp"
#include "bearing/variation.hpp"
#include "signal/window_set.hpp"

namespace piae {

/// Returns a 6205 at 12 kHz and 1797 rpm: healthy, inner race and outer race.
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

/// A window by eq. 13 and the impact angle at its middle: the number of impacts up to there, times
/// 2 pi; 0 where the defect and a ball (or the ball's defect and a race) meet.
struct ImpactWindow {
  std::vector<double> samples;
  double impact_angle_rad = 0;
};

/// Returns a window with (k, c), speed, slip and angles drawn as in a simulated dataset, with white
/// noise 10 dB below the signal.
inline ImpactWindow impact_window(const signal::DatasetInfo& info, std::size_t label,
                                  std::size_t length, Stream stream) {
  const signal::ClassInfo& c = info.classes[label];
  const bearing::Variation variation;
  const bearing::Motion motion =
      bearing::draw_motion(stream, c.defect, info.shaft_speed_rpm, variation);
  ImpactWindow window;
  window.samples = bearing::simulate(info.bearing, {c.defect, c.defect_size_mm}, motion,
                                     bearing::draw_dynamics(stream, {}, variation),
                                     {info.sample_rate_hz, length});
  double power = 0;
  for (const double x : window.samples) power += x * x / static_cast<double>(length);
  for (double& x : window.samples) x += stream.normal(0, std::sqrt(0.1 * power));

  const bearing::Speeds speeds = bearing::speeds(info.bearing, motion.shaft_speed_rpm, motion.slip);
  const double middle_s = static_cast<double>(length) / 2 / info.sample_rate_hz;
  const double cage = motion.cage_angle_rad + speeds.cage * middle_s;
  switch (c.defect) {
    case signal::Defect::outer:
      window.impact_angle_rad = info.bearing.balls * cage;
      break;
    case signal::Defect::inner:
      window.impact_angle_rad =
          info.bearing.balls * (motion.defect_angle_rad + speeds.shaft * middle_s - cage);
      break;
    default:
      window.impact_angle_rad = 2 * (motion.defect_angle_rad + speeds.spin * middle_s);
  }
  return window;
}

/// Returns `count` known windows of each fault class, by eq. 13 with (k, c) drawn around the given
/// values.
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

}  // namespace piae
