#include "bearing/load_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace piae::bearing {
namespace {

using std::numbers::pi;

TEST(LoadZone, IsHalfATurnWithoutClearance) {
  EXPECT_DOUBLE_EQ(load_share(0, 0.5), 1);
  EXPECT_NEAR(load_share(pi / 3, 0.5), std::pow(0.5, 1.5), 1e-15);  // cos^1.5 there
  EXPECT_NEAR(load_share(pi / 2, 0.5), 0, 1e-15);
  EXPECT_EQ(load_share(pi, 0.5), 0);
}

TEST(LoadZone, IsNarrowerWithClearanceAndAllRoundWithPreload) {
  EXPECT_EQ(load_share(pi / 2, 0.25), 0);
  EXPECT_NEAR(load_share(pi / 3, 0.3), std::pow(1 - 0.5 / 0.6, 1.5), 1e-15);
  EXPECT_NEAR(load_share(pi, 2), std::pow(0.5, 1.5), 1e-15);
}

TEST(LoadZone, LiesEvenlyAboutTheLoad) {
  for (const double angle : {0.2, 0.9, 1.4}) {
    EXPECT_DOUBLE_EQ(load_share(angle, 0.4), load_share(-angle, 0.4));
    EXPECT_NEAR(load_share(angle, 0.4), load_share(angle + 2 * pi, 0.4), 1e-14);
  }
}

}  // namespace
}  // namespace piae::bearing
