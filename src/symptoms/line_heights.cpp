#include "symptoms/line_heights.hpp"

#include <algorithm>
#include <limits>

#include "bearing/strikes.hpp"

namespace piae::symptoms {

namespace {

constexpr int slip_steps = 12;  // either way
constexpr double slip_step = 0.001;
constexpr double highest = 2.5;  // how far above is more than clear says nothing

}  // namespace

std::array<double, number_of_kinds> line_orders(const bearing::Geometry& geometry) {
  constexpr double one_turn_a_second_rpm = 60;
  std::array<double, number_of_kinds> orders{};
  std::ranges::transform(kinds, orders.begin(), [&](bearing::Defect kind) {
    return bearing::strike_frequency_hz(geometry, kind, one_turn_a_second_rpm);
  });
  return orders;
}

double last_order(const std::array<double, number_of_kinds>& orders) {
  return most_harmonics * (1 + slip_steps * slip_step) * *std::ranges::max_element(orders);
}

double line_height(const OrderSpectrum& spectrum, double order, int harmonics, double lowest) {
  double best = -std::numeric_limits<double>::infinity();
  for (int i = -slip_steps; i <= slip_steps; ++i) {
    double sum = 0;
    for (int n = 1; n <= harmonics; ++n) {
      sum += spectrum.at(n * order * (1 + i * slip_step), lowest, highest);
    }
    best = std::max(best, sum / harmonics);
  }
  return best;
}

}  // namespace piae::symptoms
