#include "transfer/excitation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "transfer/cepstrum.hpp"

namespace piae::transfer {
namespace {

TEST(Excitation, IsTheSumOfItsBlows) {
  const Strike first{.time_s = 0.0101, .strength = 1.5, .lag_s = 0.0013, .exit = 0.6};
  const Strike second{.time_s = 0.0237, .strength = 0.5, .lag_s = 0.0011, .exit = 0.6};
  const Eigen::ArrayXcd found = excitation({first, second}, 1025, 5.86);
  for (Eigen::Index i = 0; i < 1025; i += 64) {
    const double hz = 5.86 * static_cast<double>(i);
    std::complex<double> expected = 0;
    for (const Strike& strike : {first, second}) {
      expected += strike.strength * std::polar(1.0, -2 * std::numbers::pi * hz * strike.time_s) *
                  Edges{.lag_s = strike.lag_s, .exit = strike.exit, .spread = 0}.gain(hz);
    }
    EXPECT_NEAR(std::abs(found[i] - expected), 0, 1e-9) << hz;
  }
}

TEST(Excitation, OfOneBlowIsOneSample) {
  const double rate_hz = 12000;
  const Eigen::ArrayXd samples =
      samples_of(excitation({{.time_s = 100 / rate_hz}}, 513, rate_hz / 1024));
  for (Eigen::Index t = 0; t < 1024; ++t) {
    EXPECT_NEAR(samples[t], t == 100 ? 1 : 0, 1e-9) << t;
  }
}

}  // namespace
}  // namespace piae::transfer
