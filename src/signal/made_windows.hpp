#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"

namespace piae::signal {

/// Makes one window of a class, in the recordings' unit: its label, which window of the class it is
/// (from 0), and the window's own random numbers.
using MakeWindow = std::function<std::vector<float>(int label, std::size_t index, Stream& random)>;

/// `count` windows of each class with a defect, class by class, made one at a time. Window i of a
/// class has the stream's child "<class>/<i>" for itself, so that it is the same bit for bit
/// however many are asked for.
WindowSet make_windows(const DatasetInfo& info, std::size_t length, std::size_t count,
                       const Stream& stream, const MakeWindow& make);

}  // namespace piae::signal
