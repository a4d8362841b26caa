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

/// Where a window is made: which defect, and on which healthy window of the machine.
struct Scene {
  bearing::Defect defect = bearing::Defect::outer;
  std::int32_t condition = signal::every_condition;  ///< the tested one
  double shaft_speed_rpm = 0;                        ///< that of the healthy window
  double strike_hz = 0;                              ///< BPFO, BPFI or 2 BSF at that speed
  std::span<const float> healthy;
};

/// A machine of which no fault is known: its bearing, and healthy windows B in the tested
/// conditions.
class Machine {
 public:
  /// `healthy` must outlive this. Throws Error (bad_input) where a tested condition has no healthy
  /// window, where the bearing cannot be or its speed is not known, and where a defect is struck
  /// more often than every two samples, or less often than once in a window.
  explicit Machine(const signal::WindowSet& healthy);

  /// Window `index` of a class: in one tested condition after the other, on any healthy window of
  /// that. Of windows that belong to every condition, those are taken whose speed is nearest to the
  /// condition's.
  [[nodiscard]] Scene draw_scene(Label label, std::size_t index, Stream& random) const;

  /// How a healthy machine sounds in a condition: the logarithm of its amplitude at the bins of a
  /// frame of two windows (of one sample more, where their length is odd), with the mean 0, without
  /// its lines (impacts/response.hpp).
  [[nodiscard]] const Eigen::ArrayXd& log_amplitude(std::int32_t condition) const;

  [[nodiscard]] const signal::DatasetInfo& info() const { return healthy_.info; }
  [[nodiscard]] std::size_t length() const { return healthy_.length; }

 private:
  /// Healthy windows that are heard alike.
  struct Sound {
    std::vector<std::size_t> windows;
    Eigen::ArrayXd log_amplitude;
  };
  /// A tested condition, and which of the sounds it has.
  struct Heard {
    std::int32_t condition;
    std::size_t sound;
  };

  std::size_t sound_of(std::vector<std::size_t> windows);

  const signal::WindowSet& healthy_;
  std::vector<Sound> sounds_;
  std::vector<Heard> heard_;
};

/// Makes one window of a scene. It draws from children of the stream.
using Make = std::function<signal::MadeWindow(const Scene& scene, const Stream& random)>;

/// Makes `count` windows of each class with a defect, as signal::make_windows does. If the data set
/// has conditions, each window has the tested one and the speed of the shaft in it.
signal::WindowSet make_windows(const Machine& machine, std::size_t count, const Stream& stream,
                               const Make& make);

}  // namespace piae::zero
