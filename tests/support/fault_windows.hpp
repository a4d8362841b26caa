#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "signal/dataset_info.hpp"
#include "spectra/power.hpp"

namespace piae {

/// Returns CWRU's bearing and speed, with a class for each fault type: Normal, IR, B, OR.
inline signal::DatasetInfo cwru_like() {
  signal::DatasetInfo info;
  info.name = "example";
  info.sample_rate_hz = 12000;
  info.shaft_speed_rpm = 1797;
  info.classes = {{"Normal", signal::Defect::none, 0},
                  {"IR", signal::Defect::inner, 0.5334},
                  {"B", signal::Defect::roller, 0.5334},
                  {"OR", signal::Defect::outer, 0.5334}};
  return info;
}

/// Returns windows at 12 kHz of a class of cwru_like() by eq. 13, each with its own start angle, 1
/// % slip of balls and cage, and white noise 10 dB below the signal.
inline spectra::Windows fault_windows(int label, Eigen::Index count, Eigen::Index samples = 1024) {
  const signal::DatasetInfo dataset = cwru_like();
  const signal::ClassInfo& c = dataset.classes[static_cast<std::size_t>(label)];
  spectra::Windows windows(count, samples);
  for (Eigen::Index i = 0; i < count; ++i) {
    Stream stream("envelope/" + c.name + '/' + std::to_string(i));
    bearing::Motion motion;
    motion.shaft_speed_rpm = dataset.shaft_speed_rpm;
    motion.slip = 0.01;
    motion.cage_angle_rad = stream.uniform(0, 6.28);
    motion.defect_angle_rad = label == 3 ? 0 : stream.uniform(0, 6.28);
    const std::vector<double> clean =
        bearing::simulate(dataset.bearing, {c.defect, c.defect_size_mm}, motion, {},
                          {dataset.sample_rate_hz, static_cast<std::size_t>(samples)});
    const Eigen::Map<const Eigen::RowVectorXd> signal(clean.data(), samples);
    const double deviation = std::sqrt(0.1 * signal.squaredNorm() / static_cast<double>(samples));
    for (Eigen::Index k = 0; k < samples; ++k) {
      windows(i, k) = signal[k] + stream.normal(0, deviation);
    }
  }
  return windows;
}

}  // namespace piae
