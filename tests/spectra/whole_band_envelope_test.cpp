#include "spectra/whole_band_envelope.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace piae::spectra {
namespace {

constexpr Eigen::Index twelve_thousand = 12000;

/// Every bin of a single impact has the same amplitude, so whitening leaves a single impact.
TEST(WholeBandEnvelope, KeepsASingleImpactWhereItIs) {
  Eigen::RowVectorXd signal = Eigen::RowVectorXd::Zero(twelve_thousand);
  signal[4321] = 7;
  const Eigen::RowVectorXd envelope = whole_band_envelope(signal, 12000);
  Eigen::Index at = 0;
  const double highest = envelope.maxCoeff(&at);
  EXPECT_EQ(at, 4321);
  EXPECT_LT(envelope[4400], 1e-3 * highest);
}

/// By Parseval's theorem the mean over N samples is 4 / N^2 times the sum of the whitened power, 1
/// on average at N / 2 bins: 2 / N, at any level of the signal.
TEST(WholeBandEnvelope, HasAMeanThatDoesNotDependOnTheLevel) {
  for (const double level : {1e-3, 1.0, 1e4}) {
    Stream noise("envelope");
    Eigen::RowVectorXd signal(twelve_thousand);
    for (double& sample : signal) sample = noise.normal(0, level);
    EXPECT_NEAR(whole_band_envelope(signal, 12000).mean() * twelve_thousand, 2, 0.05);
  }
}

}  // namespace
}  // namespace piae::spectra
