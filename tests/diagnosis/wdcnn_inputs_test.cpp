#include "diagnosis/wdcnn_inputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "base/random.hpp"
#include "diagnosis/log_spectrum.hpp"
#include "diagnosis/sets.hpp"
#include "diagnosis/wdcnn_layers.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

/// Returns two windows of noise, of classes 2 and 0; the second has 50 times the gain.
signal::WindowSet two_of_noise(std::size_t length) {
  Stream stream("spectral inputs");
  signal::WindowSet set = empty_set(length);
  for (const double gain : {1.0, 50.0}) {
    for (std::size_t t = 0; t < length; ++t) {
      set.samples.push_back(static_cast<float>(gain * stream.normal(1, 2)));
    }
  }
  set.labels = {2, 0};
  return set;
}

scoring::Windows row_of(const signal::WindowSet& set, std::size_t i) {
  const auto samples = set.window(i);
  return Eigen::Map<const Eigen::RowVectorXf>(samples.data(),
                                              static_cast<Eigen::Index>(samples.size()))
      .cast<double>();
}

/// Expects the inputs to be the bands, scaled to mean 0 and standard deviation 1.
void expect_standardised(std::span<const float> inputs, const Eigen::ArrayXd& bands) {
  ASSERT_EQ(inputs.size(), static_cast<std::size_t>(bands.size()));
  const double mean = bands.mean();
  const double deviation = std::sqrt((bands - mean).square().mean());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    ASSERT_NEAR(inputs[i], (bands[static_cast<Eigen::Index>(i)] - mean) / deviation, 1e-4) << i;
  }
}

TEST(SpectralInputs, Have1024ValuesForAWindowOf1024Samples) {
  const signal::WindowSet set = two_of_noise(1024);
  for (auto* const represent :
       {log_spectra, log_envelope_spectra, both_log_spectra, spectra_by_order}) {
    const LabelledWindows seen = represent(set, "--test");
    EXPECT_EQ(seen.length, 1024U);
    EXPECT_EQ(seen.samples.size(), 2048U);
    EXPECT_EQ(seen.classes, 3U);
    EXPECT_EQ(seen.labels, set.labels);
  }
}

TEST(SpectralInputs, AreLongEnoughForTheNetworkAtAnyWindowLength) {
  for (const std::size_t length : {512, 600, 1000, 1025, 2048, 4096, 8192}) {
    const signal::WindowSet set = two_of_noise(length);
    for (auto* const represent :
         {log_spectra, log_envelope_spectra, both_log_spectra, spectra_by_order}) {
      const LabelledWindows seen = represent(set, "--test");
      EXPECT_GE(static_cast<std::int64_t>(seen.length), WdcnnLayers::shortest_window) << length;
      EXPECT_GE(seen.length + 1, length);
      EXPECT_LE(seen.length, 2 * std::max<std::size_t>(length, 1024)) << length;
      EXPECT_EQ(seen.samples.size(), 2 * seen.length) << length;
    }
  }
}

TEST(SpectralInputs, AreStandardisedSpectra) {
  const signal::WindowSet set = two_of_noise(1024);
  const LabelledWindows spectra = log_spectra(set, "--test");
  const LabelledWindows envelopes = log_envelope_spectra(set, "--test");
  for (const std::size_t i : {0, 1}) {
    const auto inputs_of = [&](const LabelledWindows& seen) {
      return std::span(seen.samples).subspan(1024 * i, 1024);
    };
    expect_standardised(inputs_of(spectra), log_spectrum(row_of(set, i), 1024, 1e-9));
    expect_standardised(inputs_of(envelopes), log_envelope_spectrum(row_of(set, i), 1024, 1e-9));
  }
}

TEST(SpectralInputs, BothSpectraAreStandardisedSeparately) {
  const signal::WindowSet set = two_of_noise(1024);
  const LabelledWindows both = both_log_spectra(set, "--test");
  for (const std::size_t i : {0, 1}) {
    const std::span<const float> inputs = std::span(both.samples).subspan(1024 * i, 1024);
    expect_standardised(inputs.first(512), log_spectrum(row_of(set, i), 512, 1e-9));
    expect_standardised(inputs.last(512), log_envelope_spectrum(row_of(set, i), 512, 1e-9));
  }
}

// 1024 samples at 12 kHz are 2.56 turns at 1800 rpm, and 1.28 turns at 900 rpm.
TEST(SpectralInputs, OrdersOfTheEnvelopeAreAtTheSpeedOfEachWindow) {
  signal::WindowSet set = two_of_noise(1024);
  set.shaft_speed_rpm = {1800, 900};
  const LabelledWindows seen = spectra_by_order(set, "--test");
  for (const std::size_t i : {0, 1}) {
    const std::span<const float> inputs = std::span(seen.samples).subspan(1024 * i, 1024);
    expect_standardised(inputs.first(512), log_spectrum(row_of(set, i), 512, 1e-9));
    expect_standardised(inputs.last(512),
                        log_order_spectrum(row_of(set, i), i == 0 ? 2.56 : 1.28, 512, 1e-9));
  }
}

TEST(SpectralInputs, OrdersNeedASpeed) {
  signal::WindowSet set = two_of_noise(1024);
  set.shaft_speed_rpm = {1800, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_ERROR(spectra_by_order(set, "training set"), Exit::bad_input,
               "--generated: the windows lack shaft speeds, which a spectrum over orders");
}

TEST(SpectralInputs, SilentBandIsFiniteAndIndependentOfTheGain) {
  signal::WindowSet set = empty_set(1024);
  for (const float gain : {1e-6F, 1e6F}) {
    for (std::size_t t = 0; t < 1024; ++t) {
      set.samples.push_back(gain * static_cast<float>(std::sin(std::numbers::pi / 4 * t + 1)));
    }
  }
  set.labels = {1, 1};
  for (auto* const represent :
       {log_spectra, log_envelope_spectra, both_log_spectra, spectra_by_order}) {
    const std::vector<float> seen = represent(set, "--test").samples;
    for (std::size_t i = 0; i < 1024; ++i) {
      ASSERT_TRUE(std::isfinite(seen[i])) << i;
      ASSERT_NEAR(seen[i], seen[1024 + i], 1e-3) << i;
    }
  }
  // A steady tone has a flat envelope spectrum.
  EXPECT_THAT(log_envelope_spectra(set, "--test").samples, testing::Each(0));
}

TEST(SpectralInputs, ConstantWindowIsRefused) {
  signal::WindowSet set = two_of_noise(1024);
  std::fill(set.samples.begin() + 1024, set.samples.end(), 4.0F);
  for (auto* const represent :
       {log_spectra, log_envelope_spectra, both_log_spectra, spectra_by_order}) {
    EXPECT_ERROR(represent(set, "--known"), Exit::bad_input,
                 "--known: window 1 (class Normal) is constant");
  }
}

}  // namespace
}  // namespace piae::diagnosis
