#include "scoring/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bearing/dynamics.hpp"
#include "scoring/quality.hpp"
#include "scoring/sets.hpp"

namespace piae::scoring {
namespace {

using signal::Defect;

constexpr double rate_hz = 12000;
constexpr Eigen::Index length = 1024;

double turns(double cycles, Eigen::Index i) {
  return 2 * std::numbers::pi * cycles * static_cast<double>(i) / static_cast<double>(length);
}

/// CWRU's bearing and speed, with a class for each defect.
signal::DatasetInfo info() {
  signal::DatasetInfo info;
  info.name = "example";
  info.sample_rate_hz = rate_hz;
  info.shaft_speed_rpm = 1797;
  info.classes = {{"Normal", Defect::none, 0},
                  {"IR", Defect::inner, 0.5334},
                  {"B", Defect::roller, 0.5334},
                  {"OR", Defect::outer, 0.5334}};
  return info;
}

/// Windows of a class by eq. 13, each from an angle of its own, the balls and the cage sliding by
/// 1 %, with white noise 10 dB below.
Windows simulated(int label, Eigen::Index count, Eigen::Index samples = length) {
  const signal::DatasetInfo dataset = info();
  const signal::ClassInfo& c = dataset.classes[static_cast<std::size_t>(label)];
  Windows windows(count, samples);
  for (Eigen::Index i = 0; i < count; ++i) {
    Stream stream("envelope/" + c.name + '/' + std::to_string(i));
    bearing::Motion motion;
    motion.shaft_speed_rpm = dataset.shaft_speed_rpm;
    motion.slip = 0.01;
    motion.cage_angle_rad = stream.uniform(0, 6.28);
    motion.defect_angle_rad = label == 3 ? 0 : stream.uniform(0, 6.28);
    const std::vector<double> clean =
        bearing::simulate(dataset.bearing, {c.defect, c.defect_size_mm}, motion, {},
                          {rate_hz, static_cast<std::size_t>(samples)});
    const Eigen::Map<const Eigen::RowVectorXd> signal(clean.data(), samples);
    const double deviation = std::sqrt(0.1 * signal.squaredNorm() / static_cast<double>(samples));
    for (Eigen::Index k = 0; k < samples; ++k) {
      windows(i, k) = signal[k] + stream.normal(0, deviation);
    }
  }
  return windows;
}

double line_db(const Windows& windows, Defect defect) {
  return fault_line_db(windows, fault_line_hz(info(), defect), rate_hz);
}

/// Table 1's bearing at 1797 rpm, worked by hand.
TEST(FaultLine, LiesAtTheFrequencyOfTheDefect) {
  EXPECT_NEAR(fault_line_hz(info(), Defect::outer), 107.34, 0.01);
  EXPECT_NEAR(fault_line_hz(info(), Defect::inner), 162.21, 0.01);
  EXPECT_NEAR(fault_line_hz(info(), Defect::roller), 2 * 70.51, 0.02);
  EXPECT_EQ(fault_line_hz(info(), Defect::none), 0);
}

/// A carrier of whole cycles: A (1 + m cos) is its envelope, whatever the window's offset.
TEST(Envelope, OfAModulatedCarrierIsItsModulation) {
  Windows window(1, length);
  Eigen::RowVectorXd modulation(length);
  for (Eigen::Index i = 0; i < length; ++i) {
    modulation[i] = 2 * (1 + 0.5 * std::cos(turns(10, i)));
    window(0, i) = 5 + modulation[i] * std::cos(turns(200, i) + 0.3);
  }
  EXPECT_LT((envelopes(window).row(0) - modulation).cwiseAbs().maxCoeff(), 1e-10);
}

/// Modulated by cos of depth m at 9, 18 and 27 cycles and by noise: cos of depth a and any phase at
/// each of 1 ... 40 cycles. Hann's window makes (m N / 4)^2 of a line and, as its squares have the
/// mean 3 / 8, N^2 (a^2 / 4) 3 / 8 of the noise. Their sum over the latter is 1 + 2 m^2 / (3 a^2).
TEST(FaultLine, OfAKnownModulationHasItsClosedForm) {
  constexpr double m = 0.1;
  constexpr double a = 0.02;
  Windows windows(200, length);
  Stream stream("modulation");
  for (Eigen::Index row = 0; row < windows.rows(); ++row) {
    Eigen::RowVectorXd envelope = Eigen::RowVectorXd::Ones(length);
    for (int cycles = 1; cycles <= 40; ++cycles) {
      const double phase = stream.uniform(0, 2 * std::numbers::pi);
      const double line_phase = stream.uniform(0, 2 * std::numbers::pi);
      for (Eigen::Index i = 0; i < length; ++i) {
        envelope[i] += a * std::cos(turns(cycles, i) + phase);
        if (cycles == 9 || cycles == 18 || cycles == 27) {
          envelope[i] += m * std::cos(turns(cycles, i) + line_phase);
        }
      }
    }
    for (Eigen::Index i = 0; i < length; ++i) {
      windows(row, i) = envelope[i] * std::cos(turns(256, i));
    }
  }
  const double bin_hz = rate_hz / static_cast<double>(length);
  const double expected = 10 * std::log10(1 + 2 * m * m / (3 * a * a));
  EXPECT_NEAR(fault_line_db(windows, 9 * bin_hz, rate_hz), expected, 0.3);
  EXPECT_NEAR(fault_line_db(windows * 1000, 9 * bin_hz, rate_hz), expected, 0.3);
  EXPECT_NEAR(fault_line_db(windows, 9 * bin_hz * 1.01, rate_hz), expected, 0.3) << "speed";
}

/// An inner race's defect passes the load zone once a turn of the shaft: its line has neighbours 30
/// Hz away, which 1024 samples hardly separate, and 4096 do.
TEST(FaultLine, OfSimulatedFaultsIsTheirOwn) {
  for (const int label : {1, 2, 3}) {
    const Windows windows = simulated(label, 12, 4096);
    const Defect own = info().classes[static_cast<std::size_t>(label)].defect;
    EXPECT_GT(line_db(windows, own), 15) << label;
    for (const Defect other : {Defect::inner, Defect::roller, Defect::outer}) {
      if (other == own) continue;
      EXPECT_LT(line_db(windows, other), line_db(windows, own) - 5) << label;
      const Windows heads = windows.leftCols(length);
      EXPECT_LT(line_db(heads, other), line_db(heads, own) - 1) << label;
    }
  }
}

TEST(FaultLine, OfWhiteNoiseIsNone) {
  const Windows windows = noise(200, static_cast<std::size_t>(length), "white");
  for (const Defect defect : {Defect::inner, Defect::roller, Defect::outer}) {
    EXPECT_NEAR(line_db(windows, defect), 0, 1);
  }
}

TEST(FaultLine, OfSilenceIsNone) {
  EXPECT_EQ(line_db(Windows::Zero(2, length), Defect::outer), 0);
  EXPECT_EQ(line_db(Windows::Constant(2, length, 0.1F), Defect::outer), 0);
}

/// 256 samples hold 2.3 periods of BPFO.
TEST(FaultLine, ThatWindowsAreTooShortForIsNone) {
  const Windows windows = simulated(3, 4);
  EXPECT_EQ(fault_line_db(windows.leftCols(256), 107.34, rate_hz), 0);
  EXPECT_EQ(fault_line_db(windows, 0, rate_hz), 0);
  EXPECT_EQ(fault_line_db(windows, 6000, rate_hz), 0) << "at half the sampling rate";
}

TEST(FaultLine, OfNoWindowsIsRefused) {
  EXPECT_THROW((void)fault_line_db(Windows(0, length), 100, rate_hz), std::logic_error);
}

signal::WindowSet set_of(int label, const Windows& windows) {
  signal::WindowSet set;
  set.info = info();
  for (Eigen::Index i = 0; i < windows.rows(); ++i) {
    const Eigen::RowVectorXf row = windows.row(i).cast<float>();
    add(set, label, {row.data(), row.data() + row.size()});
  }
  return set;
}

double difference_db(const signal::WindowSet& generated, const signal::WindowSet& real) {
  return quality_by_class(generated, real).front().fault_line_difference_db;
}

TEST(FaultLine, IsJudgedAgainstRealWindowsOfTheClass) {
  const signal::WindowSet real = set_of(3, simulated(3, 20));
  EXPECT_EQ(difference_db(real, real), 0);
  EXPECT_GT(quality_by_class(real, real).front().fault_line_db, 6);
  const Windows white = noise(20, static_cast<std::size_t>(length), "white");
  EXPECT_LT(difference_db(set_of(3, white), real), -6);
  EXPECT_LT(difference_db(set_of(3, simulated(1, 20)), real), -6);
}

}  // namespace
}  // namespace piae::scoring
