#include "impacts/path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace piae::impacts {
namespace {

double rms(const std::vector<double>& samples) {
  double sum = 0;
  for (const double x : samples) sum += x * x;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

/// Returns two tones of amplitude 1, at bins 8 and 16 of 64 samples.
std::vector<double> two_tones() {
  std::vector<double> samples(64);
  for (std::size_t t = 0; t < samples.size(); ++t) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(t) / 64;
    samples[t] = std::sin(8 * turn) + std::sin(16 * turn);
  }
  return samples;
}

TEST(Equaliser, MultipliesTonesAndKeepsTheirPhaseAndTheLevel) {
  std::vector<double> samples = two_tones();
  Eigen::ArrayXd gains = Eigen::ArrayXd::Ones(33);
  gains[16] = 3;
  equalise(samples, gains);
  const double level = std::sqrt(2.0 / (1 + 9));
  for (std::size_t t = 0; t < samples.size(); ++t) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(t) / 64;
    EXPECT_NEAR(samples[t], level * (std::sin(8 * turn) + 3 * std::sin(16 * turn)), 1e-12);
  }
  EXPECT_NEAR(rms(samples), 1, 1e-12);
}

TEST(Equaliser, KeepsSilenceAndRefusesAWrongNumberOfGains) {
  std::vector<double> silence(8, 0.0);
  equalise(silence, Eigen::ArrayXd::Constant(5, 2));
  EXPECT_EQ(silence, std::vector<double>(8, 0.0));
  EXPECT_THROW(equalise(silence, Eigen::ArrayXd::Constant(4, 2)), std::logic_error);
}

TEST(Equaliser, DrawsGainsThatAreNormalInDbAtTheKnotsAndStraightBetween) {
  constexpr int draws = 4000;
  const EqualiserOptions options{.spread_db = 6, .knots = 3};
  Stream random("gains");
  double squares = 0;
  for (int i = 0; i < draws; ++i) {
    std::vector<double> db;
    for (const double gain : draw_gains(random, 9, options)) db.push_back(20 * std::log10(gain));
    ASSERT_EQ(db.size(), 9U);
    EXPECT_NEAR(db[2], (db[0] + db[4]) / 2, 1e-9);
    EXPECT_NEAR(db[5], db[4] + (db[8] - db[4]) / 4, 1e-9);
    squares += db[0] * db[0] + db[4] * db[4] + db[8] * db[8];
  }
  // The standard deviation of the estimate is 6 / sqrt(2 * 12000) = 0.039 dB.
  EXPECT_NEAR(std::sqrt(squares / (3 * draws)), 6, 0.13);
}

TEST(Equaliser, WithoutSpreadChangesNothing) {
  Stream random("none");
  EXPECT_TRUE(draw_gains(random, 5, {.spread_db = 0, .knots = 8}).isOnes(0));
}

}  // namespace
}  // namespace piae::impacts
