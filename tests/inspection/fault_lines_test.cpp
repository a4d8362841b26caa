#include "inspection/fault_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "support/made_recordings.hpp"

namespace piae::inspection {
namespace {

using signal::Defect;
using std::numbers::pi;
using Samples = std::vector<double>;

constexpr double rpm = 1797;
constexpr double rate_hz = 12000;
constexpr std::array fault_types{Defect::outer, Defect::inner, Defect::roller};

/// Returns the lines for CWRU's bearing, Geometry's default.
FaultLines lines_of(const Samples& samples, double rate = rate_hz, double speed_rpm = rpm) {
  return fault_lines(envelope_spectrum(samples, rate, speed_rpm / 60), {}, speed_rpm);
}

double hz_of(Defect fault_type) { return line_of(lines_of({}), fault_type).hz; }

/// Worked by hand for Table 1's bearing at 1797 rpm.
TEST(FaultLines, LieAtTheFrequenciesOfTheBearing) {
  EXPECT_NEAR(hz_of(Defect::outer), 107.34, 0.01);
  EXPECT_NEAR(hz_of(Defect::inner), 162.21, 0.01);
  EXPECT_NEAR(hz_of(Defect::roller), 141.02, 0.02);
  EXPECT_EQ(line_name(Defect::roller), "2BSF");
}

/// A record has the lines of its own speed, not of the data set's: at 900 rpm half those at 1800.
TEST(FaultLines, FollowTheSpeedOfEachRecord) {
  signal::DatasetInfo info;
  info.conditions = {
      {.name = "slow", .shaft_speed_rpm = 900, .known = true, .test = false, .healthy = true},
      {.name = "fast", .shaft_speed_rpm = 1800, .known = false, .test = true, .healthy = true}};
  const double slow = fault_lines({}, info, 900).front().hz;
  const double fast = fault_lines({}, info, 1800).front().hz;
  EXPECT_GT(slow, 0);
  EXPECT_NEAR(fast / slow, 2, 1e-12);
}

/// A carrier at a quarter of the rate with cos of depth m at f, 2 f and 3 f, in noise of deviation
/// s. Its envelope holds the noise in phase with the carrier: s^2 in a band half as wide as the
/// signal's, twice as dense. Hann's window gives (m L / 4)^2 for a line, and 2 s^2 (3 / 8) L for
/// the noise: together 1 + m^2 L / (12 s^2) times the noise.
TEST(FaultLines, MatchAKnownModulation) {
  constexpr double m = 0.02;
  constexpr double s = 0.05;
  const double f = 1.005 * hz_of(Defect::inner);  // slip
  Stream noise("modulation");
  Samples samples;
  for (int i = 0; i < 240000; ++i) {
    const double turn = 2 * pi * f * i / rate_hz;
    const double depth = m * (std::cos(turn) + std::cos(2 * turn + 1) + std::cos(3 * turn + 2));
    samples.push_back((1 + depth) * std::cos(pi / 2 * i + 0.3) + noise.normal(0, s));
  }
  const EnvelopeSpectrum spectrum = envelope_spectrum(samples, rate_hz, rpm / 60);
  const double segment = rate_hz / spectrum.resolution_hz;
  EXPECT_NEAR(segment, 16 * rate_hz / (rpm / 60), 200);
  const FaultLine inner = line_of(fault_lines(spectrum, {}, rpm), Defect::inner);
  ASSERT_TRUE(inner.db);
  EXPECT_NEAR(*inner.db, 10 * std::log10(1 + m * m * segment / (12 * s * s)), 0.3);
  EXPECT_TRUE(inner.stands_out);
  EXPECT_EQ(inner.share_elsewhere, 0);
}

TEST(FaultLines, StandOutForImpactsOnAResonance) {
  for (const Defect fault_type : fault_types) {
    const Samples samples = impact_recording(rate_hz, 6, 0.995 * hz_of(fault_type), "struck");
    const FaultLines lines = lines_of(samples);
    ASSERT_NE(farthest(lines), nullptr);
    EXPECT_EQ(farthest(lines)->fault_type, fault_type);
    EXPECT_GT(*farthest(lines)->db, 15);
  }
}

TEST(FaultLines, DoNotStandOutWhereTheSpeedIsWrong) {
  const Samples samples = impact_recording(rate_hz, 6, hz_of(Defect::outer), "struck");
  for (const double wrong : {0.9, 0.95, 1.05, 1.1, 1.3}) {
    const FaultLine outer = line_of(lines_of(samples, rate_hz, wrong * rpm), Defect::outer);
    ASSERT_TRUE(outer.db);
    EXPECT_FALSE(outer.stands_out) << wrong;
  }
}

/// The strongest place shows the error of the speed, from 2/3 to 3/2.
TEST(FaultLines, StandOutMostAtTheirOwnFrequency) {
  for (const Defect fault_type : fault_types) {
    const Samples samples = impact_recording(rate_hz, 6, hz_of(fault_type), "struck");
    for (const double declared : {0.75, 0.9, 0.95, 1.0, 1.05, 1.2, 1.4}) {
      const FaultLine line = line_of(lines_of(samples, rate_hz, declared * rpm), fault_type);
      EXPECT_NEAR(line.farthest_factor * declared, 1, 0.005)
          << line_name(fault_type) << ' ' << declared;
    }
  }
  EXPECT_EQ(line_of(lines_of({}), Defect::inner).farthest_factor, 0);
}

/// The third harmonic of BPFO lies within 1 % of the second of BPFI.
TEST(FaultLines, IgnoreOneHarmonicOfSomethingElse) {
  const FaultLine inner = line_of(
      lines_of(impact_recording(rate_hz, 6, hz_of(Defect::outer), "struck")), Defect::inner);
  EXPECT_FALSE(inner.stands_out);
}

/// 3 lines of 400 records: 1.2 above noise_db are expected at a chance of 1e-3 each, and more than
/// 6 in one of 3000 such tests. The highest of all lies near noise_db.
TEST(FaultLines, AreFoundInWhiteNoiseAtTheStatedRate) {
  int above = 0;
  double highest = 0;
  double noise_db = 0;
  for (int record = 0; record < 400; ++record) {
    const Samples samples = impact_recording(2000, 10, 0, "white/" + std::to_string(record));
    for (const FaultLine& line : lines_of(samples, 2000, 1200)) {
      ASSERT_TRUE(line.db);
      above += *line.db > line.noise_db ? 1 : 0;
      highest = std::max(highest, *line.db);
      noise_db = line.noise_db;
      EXPECT_TRUE(!line.stands_out || *line.db > line.noise_db);
    }
  }
  EXPECT_LE(above, 6);
  EXPECT_NEAR(highest, noise_db, 0.7);
}

/// 1024 samples hold 2.6 turns, at most 1 in a segment: four impacts.
TEST(FaultLines, AreNotMeasuredInTooShortOrTooSlowRecords) {
  for (const FaultLine& line : lines_of(impact_recording(rate_hz, 0.085, 107, "short"))) {
    EXPECT_FALSE(line.db);
    EXPECT_FALSE(line.stands_out);
  }
  for (const FaultLine& line : lines_of(impact_recording(300, 10, 0, "slow"), 300)) {
    EXPECT_FALSE(line.db);
  }
  EXPECT_TRUE(envelope_spectrum(Samples(3, 1.0), rate_hz, 30).power.empty());
  EXPECT_TRUE(envelope_spectrum({}, rate_hz, 30).power.empty());
}

/// 0.7 s, 21 turns, as in simulated data sets.
TEST(FaultLines, UseShorterSegmentsForAShortRecord) {
  const Samples samples = impact_recording(rate_hz, 0.7, hz_of(Defect::inner), "short");
  const EnvelopeSpectrum spectrum = envelope_spectrum(samples, rate_hz, rpm / 60);
  EXPECT_GT(spectrum.averages, 3);
  const FaultLine inner = line_of(lines_of(samples), Defect::inner);
  ASSERT_TRUE(inner.db);
  EXPECT_TRUE(inner.stands_out);
}

TEST(FaultLines, DoNotDependOnTheLevel) {
  Samples samples = impact_recording(rate_hz, 6, hz_of(Defect::outer), "struck");
  const double high_level = *line_of(lines_of(samples), Defect::outer).db;
  for (double& x : samples) x *= 1e-9;
  EXPECT_NEAR(*line_of(lines_of(samples), Defect::outer).db, high_level, 1e-6);
}

}  // namespace
}  // namespace piae::inspection
