#include "inspection/drawing.hpp"

#include <algorithm>
#include <cmath>

namespace piae::inspection {

std::vector<Point> trace_of(const std::vector<double>& values, double step, const Axis& x,
                            const Axis& y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < values.size();) {
    const double pixel = std::floor(x.at(static_cast<double>(i) * step));
    std::size_t end = i;
    while (end < values.size() && std::floor(x.at(static_cast<double>(end) * step)) == pixel) ++end;
    const auto [low, high] = std::ranges::minmax_element(values.begin() + static_cast<long>(i),
                                                         values.begin() + static_cast<long>(end));
    const bool low_first = low < high;
    points.push_back({pixel, y.at(low_first ? *low : *high)});
    if (*low < *high) points.push_back({pixel, y.at(low_first ? *high : *low)});
    i = end;
  }
  return points;
}

double tick_step(double length) {
  const double power = std::pow(10, std::floor(std::log10(length / 4)));
  const double steps = length / 4 / power;
  return power * (steps >= 5 ? 5 : steps >= 2 ? 2 : 1);
}

}  // namespace piae::inspection
