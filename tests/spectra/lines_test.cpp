#include "spectra/lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bearing/impact_frequency.hpp"
#include "scoring/sets.hpp"
#include "support/fault_windows.hpp"

namespace piae::spectra {
namespace {

using bearing::Defect;
using scoring::noise;

constexpr double rate_hz = 12000;
constexpr Eigen::Index length = 1024;

double turns(double cycles, Eigen::Index i) {
  return 2 * std::numbers::pi * cycles * static_cast<double>(i) / static_cast<double>(length);
}

double line_db(const Windows& windows, double line_hz) {
  return free_harmonics_db(envelope_spectrum(windows, rate_hz), line_hz);
}

double line_db(const Windows& windows, Defect defect) {
  return line_db(windows, bearing::impact_frequency_hz({}, defect, 1797));
}

/// The envelope is modulated by cosines of depth m at 9, 18 and 27 cycles and by noise: cosines of
/// depth a and random phase at each of 1 ... 40 cycles. With Hann's window, whose squares have the
/// mean 3 / 8, a line has the power (m N / 4)^2 and the noise N^2 (a^2 / 4) 3 / 8. Their sum over
/// the noise is 1 + 2 m^2 / (3 a^2).
TEST(FreeHarmonics, KnownModulationHasItsClosedForm) {
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
  EXPECT_NEAR(line_db(windows, 9 * bin_hz), expected, 0.3);
  EXPECT_NEAR(line_db(windows * 1000, 9 * bin_hz), expected, 0.3);
  EXPECT_NEAR(line_db(windows, 9 * bin_hz * 1.01), expected, 0.3) << "speed";
}

/// An inner race's defect passes the load zone once per shaft turn. So its line has side lines 30
/// Hz away, which 1024 samples hardly resolve; 4096 do.
TEST(FreeHarmonics, SimulatedFaultsShowTheirOwnLine) {
  for (const int label : {1, 2, 3}) {
    const Windows windows = fault_windows(label, 12, 4096);
    const Defect own = cwru_like().classes[static_cast<std::size_t>(label)].defect;
    EXPECT_GT(line_db(windows, own), 15) << label;
    for (const Defect other : {Defect::inner, Defect::roller, Defect::outer}) {
      if (other == own) continue;
      EXPECT_LT(line_db(windows, other), line_db(windows, own) - 5) << label;
      const Windows heads = windows.leftCols(length);
      EXPECT_LT(line_db(heads, other), line_db(heads, own) - 1) << label;
    }
  }
}

TEST(FreeHarmonics, WhiteNoiseGivesZero) {
  const Windows windows = noise(200, static_cast<std::size_t>(length), "white");
  for (const Defect defect : {Defect::inner, Defect::roller, Defect::outer}) {
    EXPECT_NEAR(line_db(windows, defect), 0, 1);
  }
}

TEST(FreeHarmonics, SilenceGivesZero) {
  EXPECT_EQ(line_db(Windows::Zero(2, length), Defect::outer), 0);
  EXPECT_EQ(line_db(Windows::Constant(2, length, 0.1F), Defect::outer), 0);
}

/// 256 samples hold 2.3 periods of BPFO.
TEST(FreeHarmonics, ShortWindowsGiveZero) {
  const Windows windows = fault_windows(3, 4);
  EXPECT_EQ(line_db(windows.leftCols(256), 107.34), 0);
  EXPECT_EQ(line_db(windows, 0.0), 0);
  EXPECT_EQ(line_db(windows, 6000.0), 0) << "at half the sampling rate";
}

TEST(FreeHarmonics, NoWindowsAreRefused) {
  EXPECT_THROW((void)line_db(Windows(0, length), 100.0), std::logic_error);
}

/// Returns a spectrum of `height` within 0.1 of each multiple of an order, and of -0.7 elsewhere.
OrderSpectrum comb(double order, double height) {
  OrderSpectrum spectrum{Eigen::ArrayXd(460)};
  for (Eigen::Index i = 0; i < spectrum.heights.size(); ++i) {
    const double at = OrderSpectrum::first + OrderSpectrum::step * static_cast<double>(i);
    const double harmonic = std::max(1.0, std::round(at / order));
    spectrum.heights[i] = std::abs(at - harmonic * order) < 0.1 ? height : -0.7;
  }
  return spectrum;
}

TEST(CommonSlip, FindsALineWithSlipUpTo12InAThousand) {
  for (const double slip : {-0.012, -0.005, 0.0, 0.008, 0.012}) {
    EXPECT_NEAR(common_slip_height(comb(5 * (1 + slip), 2), 5, 4, -1), 2, 1e-9) << slip;
  }
}

// For a line that slips by 5 %, the search ends 3.8 % too close to 0: 0.19 orders off for the first
// harmonic and more for the others.
TEST(CommonSlip, DoesNotFindALineWithMoreSlip) {
  EXPECT_NEAR(common_slip_height(comb(5 * 1.05, 2), 5, 4, -1), -0.7, 1e-9);
  EXPECT_NEAR(common_slip_height(comb(5 * 0.95, 2), 5, 1, -1), -0.7, 1e-9);
}

// With separate slips all four harmonics would be found.
TEST(CommonSlip, UsesOneSlipForAllHarmonics) {
  OrderSpectrum spectrum = comb(5, -0.7);
  const auto raise = [&](double order) {
    spectrum.heights[std::lround((order - OrderSpectrum::first) / OrderSpectrum::step)] = 2;
  };
  raise(5.05);  // + 1 %
  raise(9.9);   // - 1 %
  EXPECT_NEAR(common_slip_height(spectrum, 5, 2, -1), (2 - 0.7) / 2, 1e-9);
}

TEST(CommonSlip, IsClipped) {
  EXPECT_NEAR(common_slip_height(comb(5, 7), 5, 4, -1), 2.5, 1e-9);
  EXPECT_NEAR(common_slip_height(comb(5, -0.7), 5, 4, -0.5), -0.5, 1e-9);
}

}  // namespace
}  // namespace piae::spectra
