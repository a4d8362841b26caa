#include "bearing/orders.hpp"

#include <gtest/gtest.h>

#include "bearing/kinematics.hpp"
#include "support/errors.hpp"

namespace piae::bearing {
namespace {

/// Compares with the printed orders, at one turn a second.
void expect_orders(const Geometry& geometry, const Orders& printed) {
  const FaultFrequencies f = fault_frequencies(geometry, 60);
  EXPECT_NEAR(f.bpfo_hz, printed.bpfo, 0.01 * printed.bpfo);
  EXPECT_NEAR(f.bpfi_hz, printed.bpfi, 0.01 * printed.bpfi);
  if (printed.bsf) {
    EXPECT_NEAR(f.bsf_hz, *printed.bsf, 0.01 * *printed.bsf);
  }
  if (printed.ftf) {
    EXPECT_NEAR(f.cage_hz, *printed.ftf, 0.01 * *printed.ftf);
  }
}

/// The drive end of CWRU, as its page prints it. The printed rolling-element order is twice the
/// spin.
TEST(Orders, GiveTheProportionsOfADeepGrooveBearing) {
  const Orders cwru{.bpfo = 3.5848, .bpfi = 5.4152, .bsf = 4.7135 / 2, .ftf = 0.39828};
  const Geometry g = geometry_of(cwru);
  EXPECT_EQ(g.balls, 9);
  EXPECT_NEAR(g.ball_diameter_mm / g.pitch_diameter_mm, 7.94 / 39.04, 1e-3);
  EXPECT_NEAR(g.contact_angle_deg, 0, 2);
  expect_orders(g, cwru);
  validate(g);
}

/// Rexnord ZA-2115 (IMS): 16 rollers of 0.331 in on 2.815 in, 15.17 degrees.
TEST(Orders, GiveTheContactAngleFromTheSpin) {
  const Geometry geometry{.balls = 16,
                          .ball_diameter_mm = 8.4074,
                          .pitch_diameter_mm = 71.501,
                          .inner_raceway_mm = 63,
                          .outer_raceway_mm = 80,
                          .contact_angle_deg = 15.17};
  const FaultFrequencies f = fault_frequencies(geometry, 60);
  const Geometry g = geometry_of({.bpfo = f.bpfo_hz, .bpfi = f.bpfi_hz, .bsf = f.bsf_hz});
  EXPECT_EQ(g.balls, 16);
  EXPECT_NEAR(g.contact_angle_deg, 15.17, 1e-6);
  EXPECT_NEAR(g.ball_diameter_mm / g.pitch_diameter_mm, 8.4074 / 71.501, 1e-9);
}

TEST(Orders, AssumeNoContactAngleWithoutASpin) {
  const Orders two{.bpfo = 3.053, .bpfi = 4.947};
  EXPECT_NEAR(geometry_of(two).contact_angle_deg, 0, 1e-6);
  expect_orders(geometry_of(two), two);
}

TEST(Orders, AreRefusedIfImpossible) {
  const auto refused = [](const Orders& orders, const std::string& why) {
    EXPECT_ERROR(geometry_of(orders), Exit::bad_input, why);
  };
  refused({.bpfo = 5.4, .bpfi = 3.6}, "bpfo is 5.4 and bpfi 3.6; 0 < bpfo < bpfi");
  refused({.bpfo = 3.6, .bpfi = 5.9}, "bpfo + bpfi is 9.5; it must be the number of balls");
  refused({.bpfo = 0.8, .bpfi = 1.2}, "bpfo + bpfi is 2; it must be the number of balls");
  refused({.bpfo = 3.585, .bpfi = 5.415, .bsf = {}, .ftf = 0.45}, "ftf is 0.45, but bpfo / balls");
  refused({.bpfo = 3.585, .bpfi = 5.415, .bsf = 4.7135}, "twice the spin of a ball");
  refused({.bpfo = 3.585, .bpfi = 5.415, .bsf = 3},
          "bsf is 3, but with these bpfo and bpfi it is at");
}

}  // namespace
}  // namespace piae::bearing
