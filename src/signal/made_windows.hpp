#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// One generated window, in the unit of the recordings, with the optional data of WindowSet. All
/// windows of a set must have the same data.
struct MadeWindow {
  std::vector<float> samples;
  std::optional<std::vector<double>> impact_times_s = {};
  std::optional<DynamicParameters> parameters = {};
  std::optional<std::int32_t> condition = {};
  std::optional<double> shaft_speed_rpm = {};
  std::optional<Parents> parents = {};

  // Implicit, so that a function that returns only samples is a MakeWindow.
  MadeWindow(std::vector<float> made = {})
      : samples(std::move(made)) {}  // NOLINT(google-explicit-constructor)
};

/// Makes one window. `index` counts the windows of its class from 0. Only this window uses
/// `random`.
using MakeWindow = std::function<MadeWindow(Label label, std::size_t index, Stream& random)>;

/// Makes `count` windows of each class with a defect, class by class, `length` samples each. Window
/// i of a class draws only from the stream's child "<class>/<i>". It is therefore the same, bit for
/// bit, for any `count`.
WindowSet make_windows(const DatasetInfo& info, std::size_t length, std::size_t count,
                       const Stream& stream, const MakeWindow& make);

/// Returns the indices of a window's known windows, without duplicates.
Parents parents_of(std::initializer_list<std::size_t> known);

}  // namespace piae::signal
