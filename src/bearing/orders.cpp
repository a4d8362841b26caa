#include "bearing/orders.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

/// Relative tolerance between printed orders and those of a geometry, because makers round them.
constexpr double order_tolerance = 0.01;

[[noreturn]] void refuse_orders(const std::string& what) { throw Error(Exit::bad_input, what); }

bool agree(double a, double b) { return std::abs(a - b) <= order_tolerance * std::abs(b); }

int number_of_balls(const Orders& orders) {
  const double sum = orders.bpfo + orders.bpfi;
  const double balls = std::round(sum);
  if (balls < 3 || !agree(sum, balls)) {
    refuse_orders(fmt::format(
        "bpfo + bpfi is {:g}; it must be the number of balls, a whole number of at least 3", sum));
  }
  return static_cast<int>(balls);
}

void require_cage(const Orders& orders, int balls) {
  const double expected = orders.bpfo / balls;
  if (orders.ftf && !agree(*orders.ftf, expected)) {
    refuse_orders(fmt::format("ftf is {:g}, but bpfo / balls = {:g} / {} is {:.4g}", *orders.ftf,
                              orders.bpfo, balls, expected));
  }
}

/// Returns d / D, which is at least gamma, since a cosine is at most 1.
double ball_to_pitch(const Orders& orders, double gamma) {
  if (!orders.bsf) return gamma;
  const double ratio = (1 - gamma * gamma) / (2 * *orders.bsf);
  if (ratio >= gamma) return ratio;
  if (agree(ratio, gamma)) return gamma;
  const double spin = (1 - gamma * gamma) / (2 * gamma);
  const char* const hint =
      agree(*orders.bsf, 2 * spin) ? ": it is twice the spin of a ball, so give half of it" : "";
  refuse_orders(fmt::format("bsf is {:g}, but with these bpfo and bpfi it is at most {:.4g}{}",
                            *orders.bsf, spin, hint));
}

}  // namespace

Geometry geometry_of(const Orders& orders) {
  if (!(orders.bpfo > 0 && orders.bpfi > orders.bpfo)) {
    refuse_orders(fmt::format("bpfo is {:g} and bpfi {:g}; 0 < bpfo < bpfi holds for every bearing",
                              orders.bpfo, orders.bpfi));
  }
  const int balls = number_of_balls(orders);
  require_cage(orders, balls);
  const double gamma = (orders.bpfi - orders.bpfo) / (orders.bpfi + orders.bpfo);
  const double ratio = ball_to_pitch(orders, gamma);
  Geometry geometry;
  geometry.balls = balls;
  geometry.pitch_diameter_mm = nominal_pitch_mm;
  geometry.ball_diameter_mm = ratio * nominal_pitch_mm;
  geometry.inner_raceway_mm = nominal_pitch_mm - geometry.ball_diameter_mm;
  geometry.outer_raceway_mm = nominal_pitch_mm + geometry.ball_diameter_mm;
  geometry.contact_angle_deg = std::acos(gamma / ratio) * 180 / std::numbers::pi;
  return geometry;
}

}  // namespace piae::bearing
