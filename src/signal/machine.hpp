#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "cli/options.hpp"
#include "signal/simulation.hpp"

namespace piae::signal {

/// Options of one machine that runs continuously and may get a defect.
struct MachineOptions {
  double duration_s = 60;
  double appears_at_s = 0;  ///< start of the defect
  double drift_s = 600;     ///< correlation time of stiffness, damping, speed and slip
  std::int64_t seed = 0;    ///< each seed is another machine

  bool operator==(const MachineOptions&) const = default;
};

void bind(const cli::Options& command, MachineOptions& options);

/// The signal of a simulated machine, stretch by stretch. Stiffness, damping, speed and slip vary
/// as much as between the records of the data set, but slowly. Each is a first-order autoregression
/// in steps of a stretch, with the records' distribution and a correlation of exp(-t / drift_s).
/// The angles of shaft, cage and balls continue from stretch to stretch.
///
/// next() solves eq. 13 for several stretches of one second in parallel, each with its own
/// stiffness and damping. Each solution starts early enough for its initial state to decay (12 time
/// constants of the smallest damping, 6e-6). Solving one stretch after another would leave all but
/// one lane of the processor idle. Only the stretch in which a defect appears continues from the
/// healthy bearing's state.
///
/// Random numbers come from Stream("<data set>/seed<k>/machine/..."). Until the defect appears, the
/// signal of a seed does not depend on the defect, bit for bit.
class Machine {
 public:
  /// `class_name` is the class of the bearing from appears_at_s on, or the healthy class. Computes
  /// the measurement noise, which takes as long as simulating the data set's records. Throws
  /// Error(usage) for an unknown class, or if the defect would appear after the end.
  Machine(const Simulation& simulation, const std::string& class_name,
          const MachineOptions& options);

  /// Returns the next samples in m/s^2, some seconds of them; empty at the end. Throws
  /// Error(failed) if eq. 13 diverges.
  std::vector<float> next();

  [[nodiscard]] std::uint64_t samples() const { return samples_; }

 private:
  [[nodiscard]] std::size_t next_length() const;
  [[nodiscard]] bearing::Course course() const;
  void run_on(std::size_t samples);

  Simulation simulation_;
  bearing::LocalDefect defect_;
  double noise_deviation_ = 0;
  double correlation_;     ///< of the deviations from one stretch to the next
  std::size_t stretch_;    ///< samples of a stretch; shorter before the onset and the end
  std::uint64_t samples_;  ///< of the whole signal
  std::uint64_t onset_;    ///< first sample with the defect; samples_ without one
  std::uint64_t done_ = 0;
  bearing::DynamicsOptions dynamics_;   ///< with the means and the settling time
  bearing::Motion motion_;              ///< with the current angles
  std::array<double, 4> deviations_{};  ///< of stiffness, damping, speed, slip: standard normal
  Stream drift_;
  Stream noise_;
};

}  // namespace piae::signal
