#pragma once

#include <vector>

#include "inspection/svg.hpp"

namespace piae::inspection {

/// A rectangle of the drawing, in pixels.
struct Panel {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

/// An axis that maps numbers from `low` to `high` to pixels.
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

/// Returns the lowest and highest value on each pixel as joined points: the most that the drawing
/// can show. Values are `step` apart on the axis x.
std::vector<Point> trace_of(const std::vector<double>& values, double step, const Axis& x,
                            const Axis& y);

/// Returns a tick step of 1, 2 or 5 times a power of ten, for four to ten steps on an axis.
double tick_step(double length);

}  // namespace piae::inspection
