#include "phase/features.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"

namespace piae::phase {
namespace {

// The definition: sum over t of x(t) x(t + lag), about the mean and without wrapping.
TEST(Autocorrelation, EqualsItsDefinition) {
  Stream stream("window");
  std::vector<float> window(600);
  double mean = 0;
  for (float& x : window) {
    x = static_cast<float>(stream.normal(3, 2));
    mean += x / 600.0;
  }
  const auto sum = [&](std::size_t lag) {
    double s = 0;
    for (std::size_t t = 0; t + lag < 600; ++t) s += (window[t] - mean) * (window[t + lag] - mean);
    return s;
  };
  const std::vector<float> features = autocorrelation(window);
  ASSERT_EQ(features.size(), feature_lags);
  for (const std::size_t lag : {1U, 2U, 100U, 256U}) {
    EXPECT_NEAR(features[lag - 1], sum(lag) / sum(0), 1e-5) << lag;
  }
}

// exp(-a t) cos(w t) for t >= 0 has the autocorrelation exp(-a lag) cos(w lag) if a is much smaller
// than w. The inference gets stiffness and damping from this form.
TEST(Autocorrelation, RingingGivesTheRinging) {
  constexpr double decay = 0.02;
  constexpr double pitch = 0.9;
  std::vector<float> window(1024);
  for (std::size_t t = 0; t < window.size(); ++t) {
    const auto time = static_cast<double>(t);
    window[t] = static_cast<float>(std::exp(-decay * time) * std::cos(pitch * time));
  }
  const std::vector<float> features = autocorrelation(window);
  for (std::size_t lag = 1; lag <= 100; ++lag) {
    const auto time = static_cast<double>(lag);
    EXPECT_NEAR(features[lag - 1], std::exp(-decay * time) * std::cos(pitch * time), 0.03) << lag;
  }
}

TEST(Autocorrelation, ConstantWindowGivesNan) {
  EXPECT_FALSE(std::isfinite(autocorrelation(std::vector<float>(512, 1.5F)).front()));
}

}  // namespace
}  // namespace piae::phase
