#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "zero/machine.hpp"

namespace piae::zero {

/// A window that was made, and what is known of it.
struct Made {
  std::vector<float> samples;
  std::vector<double> strikes_s;  ///< from its first sample, ascending
  std::optional<signal::DynamicParameters> ring;
};

using Make = std::function<Made(const Scene& scene, const Stream& random)>;

/// Makes `count` windows of each class with a defect, class by class, as signal::make_windows does.
/// Where the data set tells conditions apart, each says the tested one in which it is, and the
/// speed of the shaft in it.
signal::WindowSet make_windows(const Machine& machine, std::size_t count, const Stream& stream,
                               const Make& make);

}  // namespace piae::zero
