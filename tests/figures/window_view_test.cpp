#include "figures/window_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/three_classes.hpp"

namespace piae::figures {
namespace {

constexpr Eigen::Index length = 1024;
constexpr double rate_hz = 12000;

/// Returns a tone of 3000 Hz, optionally modulated at 140.625 Hz. Both lie on bins.
scoring::Windows tone(double amplitude, double swing = 0) {
  scoring::Windows window(1, length);
  for (Eigen::Index i = 0; i < length; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / rate_hz;
    window(0, i) = (amplitude + swing * std::cos(140.625 * turn)) *
                   std::cos(3000 * turn + std::numbers::pi / 3);
  }
  return window;
}

scoring::Windows three_tones() {
  scoring::Windows windows(3, length);
  windows << tone(1), tone(5), tone(2);
  return windows;
}

ViewAxes axes() { return {three_classes(), length}; }

template <class Hz>
Eigen::Index point_at(double hz, const Eigen::ArrayXd& values, const Hz& hz_of) {
  Eigen::Index nearest = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (std::abs(hz_of(i) - hz) < std::abs(hz_of(nearest) - hz)) nearest = i;
  }
  return nearest;
}

TEST(TypicalWindow, HasTheMedianRms) {
  EXPECT_EQ(typical_window(three_tones()), 2);
  EXPECT_EQ(typical_window(three_tones().topRows(2)), 0);
  EXPECT_THROW(typical_window(three_tones().topRows(0)), std::logic_error);
}

TEST(TypicalWindow, IgnoresAnOffset) {
  scoring::Windows windows = three_tones();
  windows.row(0).array() += 100;
  EXPECT_EQ(typical_window(windows), 2);
}

TEST(WindowView, ShowsTheExtremesOfTheTypicalWindow) {
  const WindowView view = view_of(three_tones(), axes());
  ASSERT_EQ(view.low.size(), 128);  // of eight samples each, two periods of the tone
  EXPECT_NEAR(view.high[0], std::sqrt(3.0), 1e-9);  // 2 cos(pi / 3 + k pi / 2)
  EXPECT_NEAR(view.low[127], -std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(axes().waveform_ms(127), (1024 - 4.5) / 12, 1e-9);
}

TEST(WindowView, ShowsTheNamedWindow) {
  const WindowView view = view_of(three_tones(), 1, axes());
  EXPECT_NEAR(view.high[0], 5 * std::sqrt(3.0) / 2, 1e-9);
  EXPECT_NEAR(view.spectrum_db.maxCoeff(), 10 * std::log10((1.0 + 25 + 4) / 3), 1e-9);
}

TEST(WindowView, HasTheLevelOfAToneAtItsFrequency) {
  const WindowView view = view_of(tone(2), axes());
  const Eigen::Index at =
      point_at(3000, view.spectrum_db, [](Eigen::Index i) { return axes().spectrum_hz(i); });
  EXPECT_NEAR(view.spectrum_db[at], 20 * std::log10(2.0), 1e-9);
  EXPECT_LT(view.spectrum_db[at + 2], -200 + 1e-9);
  EXPECT_NEAR(axes().spectrum_hz(0), 2.5 * rate_hz / length, 1e-9);  // bins 1 to 4
}

TEST(WindowView, HasTheMeanPowerOfAllWindows) {
  const WindowView view = view_of(three_tones(), axes());
  EXPECT_NEAR(view.spectrum_db.maxCoeff(), 10 * std::log10((1.0 + 25 + 4) / 3), 1e-9);
}

TEST(WindowView, HasTheLevelOfTheSwingInTheEnvelope) {
  const WindowView view = view_of(tone(2, 0.5), axes());
  const auto hz = [](Eigen::Index i) { return axes().envelope_hz(i); };
  const Eigen::Index at = point_at(140.625, view.envelope_db, hz);
  EXPECT_NEAR(hz(at), 140.625, 1e-9);
  EXPECT_NEAR(view.envelope_db[at], 20 * std::log10(0.5), 1e-6);
  EXPECT_EQ(view.envelope_db.maxCoeff(), view.envelope_db[at]);
}

/// A 6205 at 1800 rpm: BPFI is the highest line, 162.44 Hz.
TEST(WindowView, ShowsTheEnvelopeUpToTheThirdHarmonics) {
  const WindowView view = view_of(tone(1), axes());
  const double last_hz = axes().envelope_hz(view.envelope_db.size() - 1);
  EXPECT_NEAR(last_hz, 3 * 162.44 + 2 * 30, rate_hz / length);
}

/// BPFI is 324.97 Hz at 3600 rpm.
TEST(WindowView, ShowsTheEnvelopeUpToTheLinesOfTheFastestShaft) {
  const ViewAxes faster(three_classes(), length, 3600);
  const WindowView view = view_of(tone(1), faster);
  EXPECT_NEAR(faster.envelope_hz(view.envelope_db.size() - 1), 3 * 324.97 + 2 * 60,
              rate_hz / length);
}

TEST(WindowView, HasEnoughPointsForTheLinesOfASlowShaft) {
  signal::DatasetInfo slow = three_classes();
  slow.shaft_speed_rpm = 180;
  const WindowView view = view_of(tone(1), {slow, length});
  EXPECT_GE(view.envelope_db.size(), 64);
  EXPECT_LE(view.envelope_db.size(), 128);
}

TEST(WindowView, HasTheLevelOfAToneInTheSpectrogram) {
  const WindowView view = view_of(tone(2), axes());
  ASSERT_EQ(view.spectrogram_db.rows(), 63);
  ASSERT_EQ(view.spectrogram_db.cols(), 17);
  EXPECT_NEAR(view.spectrogram_db(40, 8), 20 * std::log10(2.0), 1e-9);
  EXPECT_EQ(axes().spectrogram_hz(8), 3000);
  EXPECT_NEAR(axes().spectrogram_ms(0), 16 / 12.0, 1e-12);
}

TEST(WindowView, IsVeryLowForSilence) {
  const WindowView view = view_of(scoring::Windows::Zero(2, length), axes());
  EXPECT_EQ(view.spectrum_db.maxCoeff(), -200);
  EXPECT_EQ(view.envelope_db.maxCoeff(), -200);
  EXPECT_EQ(view.spectrogram_db.maxCoeff(), -200);
  EXPECT_EQ(view.high.maxCoeff(), 0);
}

}  // namespace
}  // namespace piae::figures
