#pragma once

#include <vector>

#include "inspection/svg.hpp"

namespace piae::inspection {

/// A rectangle on paper, in pixels.
struct Panel {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

/// A place on paper for numbers from `low` to `high`.
struct Axis {
  double low;
  double high;
  double from;  ///< pixels
  double to;

  [[nodiscard]] double at(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

inline const Stroke signal_stroke{"#444444", 0.8};
inline const Stroke grid_stroke{"#dddddd", 0.6};

/// The lowest and highest of the values that fall on each pixel, joined: as many points as the
/// paper can show. Values are `step` apart on the axis x.
std::vector<Point> trace_of(const std::vector<double>& values, double step, const Axis& x,
                            const Axis& y);

/// 1, 2 or 5 times a power of ten: between four and ten steps to the end of an axis.
double tick_step(double length);

}  // namespace piae::inspection
