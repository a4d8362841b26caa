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

/// One machine that runs on and on, and that may get a defect.
struct MachineOptions {
  double duration_s = 60;
  double appears_at_s = 0;  ///< until then the bearing is healthy
  double drift_s = 600;     ///< within which stiffness, damping, speed and slip change by and by
  std::int64_t seed = 0;    ///< another seed, another machine

  bool operator==(const MachineOptions&) const = default;
};

void bind(const cli::Options& command, MachineOptions& options);

/// The signal of a simulated machine, stretch after stretch. Stiffness, damping, speed and slip
/// vary as much as from record to record of the data set, but slowly: each is a first-order
/// autoregression in steps of a stretch, with the distribution of a record's and a correlation of
/// exp(-t / drift_s). The angles of shaft, cage and balls go on from stretch to stretch.
///
/// Eq. 13 is solved for several stretches of a second side by side, each with its own stiffness and
/// damping, and each from so long before its first sample that nothing is left of how it began
/// (12 time constants of the least damping, 6e-6). That is as fast as many machines at once, where
/// one state after the other would leave all but one lane of the processor idle. Only from the
/// stretch in which a defect appears, the state goes on from the healthy bearing's.
///
/// Random numbers come from Stream("<data set>/seed<k>/machine/..."). Until the defect appears, the
/// signal of a seed is the same, bit for bit, whatever the defect.
class Machine {
 public:
  /// `class_name` is that of the defect which it has from appears_at_s on, or of healthy bearings.
  /// Finds the measurement noise of the data set, which takes as long as to simulate its records.
  /// Throws Error(usage) for a class that is not described, and where the defect would appear after
  /// the end.
  Machine(const Simulation& simulation, const std::string& class_name,
          const MachineOptions& options);

  /// The samples that come next, some seconds of them, in m/s^2; none at the end. Throws
  /// Error(failed) when eq. 13 diverges.
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
  std::size_t stretch_;    ///< samples of a stretch; those before the onset and the end are shorter
  std::uint64_t samples_;  ///< of the whole signal
  std::uint64_t onset_;    ///< the first sample with the defect; samples_ where there is none
  std::uint64_t done_ = 0;
  bearing::DynamicsOptions dynamics_;   ///< with the means, and the time to settle
  bearing::Motion motion_;              ///< with the angles as they are now
  std::array<double, 4> deviations_{};  ///< of stiffness, damping, speed, slip: standard normal
  Stream drift_;
  Stream noise_;
};

}  // namespace piae::signal
