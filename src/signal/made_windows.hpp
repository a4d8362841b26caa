#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// One generated window, in the unit of the recordings, and what its generator knows of it (see
/// WindowSet). All windows of a set must know the same.
struct MadeWindow {
  std::vector<float> samples;
  std::optional<std::vector<double>> strikes_s = {};
  std::optional<DynamicParameters> parameters = {};
  std::optional<std::int32_t> condition = {};
  std::optional<double> shaft_speed_rpm = {};
  std::optional<Parents> parents = {};

  // A function that makes samples alone makes windows, too.
  MadeWindow(std::vector<float> made = {})
      : samples(std::move(made)) {}  // NOLINT(google-explicit-constructor)
};

/// Makes one window. `index` counts the windows of its class from 0; `random` is for this window
/// alone.
using MakeWindow = std::function<MadeWindow(Label label, std::size_t index, Stream& random)>;

/// Makes `count` windows of each class with a defect, class by class, `length` samples each. Window
/// i of a class draws from the stream's child "<class>/<i>" and from nothing else, so it is the
/// same, bit for bit, however many are asked for.
WindowSet make_windows(const DatasetInfo& info, std::size_t length, std::size_t count,
                       const Stream& stream, const MakeWindow& make);

/// The indices of known windows as a made one says them. One that is there twice is said once.
Parents parents_of(std::initializer_list<std::size_t> known);

}  // namespace piae::signal
