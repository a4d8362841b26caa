#include "transfer/filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace piae::transfer {
namespace {

TEST(Filter, DelaysByAPhaseThatGrowsWithTheFrequency) {
  std::vector<double> window{5, 1, 0, -2, 0, 0, 3, 0};
  std::vector<std::complex<double>> gains;
  for (int i = 0; i <= 4; ++i) gains.push_back(std::polar(1.0, -2 * std::numbers::pi * i * 3 / 8));
  filter(window, gains);
  const std::vector<double> expected{0, 3, 0, 5, 1, 0, -2, 0};
  for (std::size_t t = 0; t < 8; ++t) EXPECT_NEAR(window[t], expected[t], 1e-12) << t;
}

TEST(Filter, RefusesAnotherNumberOfGains) {
  std::vector<double> window(8, 0.0);
  EXPECT_THROW(filter(window, std::vector<std::complex<double>>(8, 1.0)), std::logic_error);
}

}  // namespace
}  // namespace piae::transfer
