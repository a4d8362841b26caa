#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "bearing/kinematics.hpp"
#include "signal/made_windows.hpp"

namespace piae::zero {

/// Context of a window to make: the defect, and a healthy window of the machine.
struct Scene {
  bearing::Defect defect = bearing::Defect::outer;
  std::int32_t condition = signal::every_condition;  ///< the tested condition
  double shaft_speed_rpm = 0;                        ///< speed of the healthy window
  double impact_frequency_hz = 0;                    ///< BPFO, BPFI or 2 BSF at that speed
  std::span<const float> healthy;
};

/// A machine without known faults: its bearing, and healthy windows B in the tested conditions.
class Machine {
 public:
  /// `healthy` must outlive this. Throws Error(bad_input) if a tested condition does not have a
  /// healthy window, if the bearing is impossible or its speed unknown, or if a defect's impacts
  /// come more often than every two samples or less often than once per window.
  explicit Machine(const signal::WindowSet& healthy);

  /// Returns the scene of window `index` of a class. Tested conditions alternate; the healthy
  /// window is a random one of the condition. Of the windows that belong to every condition, only
  /// those nearest to the condition's speed are used.
  [[nodiscard]] Scene draw_scene(Label label, std::size_t index, Stream& random) const;

  /// Returns the spectrum of a healthy machine in a condition: the logarithm of its amplitude at
  /// the bins of a frame of two windows (one sample longer per window if their length is odd). Its
  /// mean is 0 and its lines are removed (impacts/response.hpp).
  [[nodiscard]] const Eigen::ArrayXd& log_amplitude(std::int32_t condition) const;

  [[nodiscard]] const signal::DatasetInfo& info() const { return healthy_.info; }
  [[nodiscard]] std::size_t length() const { return healthy_.length; }
  /// True if each healthy window has a speed of its own.
  [[nodiscard]] bool has_speeds() const { return !healthy_.shaft_speed_rpm.empty(); }

 private:
  /// Healthy windows that share a spectrum.
  struct Sound {
    std::vector<std::size_t> windows;
    Eigen::ArrayXd log_amplitude;
  };
  /// A tested condition and the index of its spectrum.
  struct HealthyCondition {
    std::int32_t condition;
    std::size_t sound;
  };

  std::size_t sound_of(std::vector<std::size_t> windows);

  const signal::WindowSet& healthy_;
  std::vector<Sound> sounds_;
  std::vector<HealthyCondition> healthy_conditions_;
};

/// Makes one window of a scene. Draws from children of the stream.
using Make = std::function<signal::MadeWindow(const Scene& scene, const Stream& random)>;

/// Makes `count` windows of each class with a defect, like signal::make_windows. If the data set
/// has conditions, each window has the tested condition; if healthy windows have speeds, that of
/// its healthy window.
signal::WindowSet make_windows(const Machine& machine, std::size_t count, const Stream& stream,
                               const Make& make);

}  // namespace piae::zero
