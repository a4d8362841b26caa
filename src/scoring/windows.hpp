#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "signal/window_set.hpp"

namespace piae::scoring {

/// Windows of one class, a row for each: [n, length], in the unit of the recordings.
using Windows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The first `count` windows of a class, in the order in which they are stored. Throws
/// std::logic_error when there are fewer.
Windows windows_of(const signal::WindowSet& set, Label label, std::size_t count);

}  // namespace piae::scoring
