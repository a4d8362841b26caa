#include "machines/machine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "symptoms/measures.hpp"

namespace piae::machines {
namespace {

Machine machine_called(int number) { return draw_machine(Stream("m" + std::to_string(number))); }

TEST(DrawnMachine, LiesWithinTheStatedRanges) {
  std::set<int> balls;
  for (int i = 0; i < 200; ++i) {
    const Machine machine = machine_called(i);
    const bearing::Geometry& bearing = machine.info.bearing;
    balls.insert(bearing.balls);
    const double ratio = bearing.ball_diameter_mm / bearing.pitch_diameter_mm;
    EXPECT_GE(ratio, 0.13);
    EXPECT_LE(ratio, 0.32);
    EXPECT_LE(bearing.balls * ratio, 2.8);
    EXPECT_GE(machine.info.sample_rate_hz, 10e3);
    EXPECT_LE(machine.info.sample_rate_hz, 26e3);
    const double turns = machine.info.shaft_speed_rpm / 60 * static_cast<double>(machine.length) /
                         machine.info.sample_rate_hz;
    EXPECT_GE(turns, 2.3 - 1e-9);
    EXPECT_LE(turns, 15 + 1e-9);
    EXPECT_NEAR(machine.log_amplitude.mean(), 0, 1e-9);
    EXPECT_EQ(machine.log_amplitude.size(), 4097);
  }
  EXPECT_GE(*balls.begin(), 6);
  EXPECT_LE(*balls.rbegin(), 16);
  EXPECT_GE(balls.size(), 8U);
}

// A window can tell two lines apart if their fourth harmonics are two bins apart.
TEST(DrawnMachine, HasFaultLinesThatAWindowTellsApart) {
  for (int i = 0; i < 200; ++i) {
    const Machine machine = machine_called(i);
    const double shaft_hz = machine.info.shaft_speed_rpm / 60;
    const double bin_hz = machine.info.sample_rate_hz / static_cast<double>(machine.length);
    const auto orders = symptoms::line_orders(machine.info.bearing);
    for (std::size_t a = 0; a < orders.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GE(4 * shaft_hz * std::abs(orders[a] - orders[b]), 2 * bin_hz * (1 - 1e-9)) << i;
      }
    }
  }
}

TEST(DrawnMachine, DependsOnItsStreamOnly) {
  EXPECT_EQ(machine_called(3).info.shaft_speed_rpm, machine_called(3).info.shaft_speed_rpm);
  EXPECT_NE(machine_called(3).info.shaft_speed_rpm, machine_called(4).info.shaft_speed_rpm);
}

}  // namespace
}  // namespace piae::machines
