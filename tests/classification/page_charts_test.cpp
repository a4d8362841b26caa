#include "classification/page_charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "classification/judged.hpp"

namespace piae::classification {
namespace {

using testing::HasSubstr;

std::vector<double> tone_with_noise(double amplitude, double hz, std::size_t samples) {
  Stream noise("tone");
  std::vector<double> signal(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    signal[i] = 0.5 +
                amplitude * std::sin(2 * std::numbers::pi * hz * static_cast<double>(i) / 12000) +
                noise.normal(0, 1e-4);
  }
  return signal;
}

// 32 turns of 30 Hz are 12800 samples of 12 kHz; Hann's window spreads a tone to half its height.
TEST(AmplitudeSpectrum, ShowsTheRmsOfATone) {
  const double hz = 1000 * 12000.0 / 12800;
  const AmplitudeSpectrum spectrum = amplitude_spectrum(tone_with_noise(2, hz, 64000), 12000, 30);
  EXPECT_DOUBLE_EQ(spectrum.bin_hz, 0.9375);
  EXPECT_EQ(spectrum.db.size(), 6401U);
  EXPECT_EQ(spectrum.segments, 9U);  // (64000 - 12800) / 6400 + 1
  EXPECT_NEAR(spectrum.db[1000], 20 * std::log10(std::numbers::sqrt2), 0.01);
  EXPECT_NEAR(spectrum.db[1001], 20 * std::log10(std::numbers::sqrt2 / 2), 0.01);
  EXPECT_LT(spectrum.db[0], -60) << "the mean is removed";
}

TEST(AmplitudeSpectrum, FitsIntoShortAndLongRecordings) {
  EXPECT_EQ(amplitude_spectrum(tone_with_noise(1, 100, 1000), 12000, 30).bin_hz, 12000.0 / 400);
  EXPECT_TRUE(amplitude_spectrum(tone_with_noise(1, 100, 20), 12000, 30).db.empty());
  const AmplitudeSpectrum slow = amplitude_spectrum(tone_with_noise(1, 100, 3000000), 12000, 0.5);
  EXPECT_EQ(slow.db.size(), 32768U / 2 + 1);
  EXPECT_EQ(slow.segments, 100U);
}

TEST(WaveformChart, HoldsTheLowestAndTheHighestSample) {
  Verdict verdict = judged("a", {1, 0, 1});
  verdict.recording.signal[1500] = 7;
  verdict.recording.signal[2000] = -8;
  const std::string numbers = waveform_chart(verdict, three_classes()).numbers;
  // 3072 samples of 12 kHz on 696 columns; column 340 starts at floor(1500.7).
  EXPECT_THAT(numbers, HasSubstr("\"step\":0.000367816092,"));
  const std::string high = numbers.substr(numbers.find("\"high\":["));
  EXPECT_EQ(
      std::ranges::count(high.begin(), high.begin() + static_cast<long>(high.find(",7,")), ','),
      340 - 1);
  EXPECT_THAT(numbers.substr(0, numbers.find("\"high\"")), HasSubstr(",-8,"));
}

TEST(EnvelopeChart, HoldsTheDecibelsOfThePicture) {
  Verdict verdict = judged("a", {1, 0, 1});
  verdict.envelope = {.power = std::vector<double>(100, 1),
                      .bin_hz = 2,
                      .resolution_hz = 8,
                      .averages = 4,
                      .rounding = 1e-20};
  verdict.envelope.power[50] = 100;
  verdict.envelope.power[60] = 1e-3;
  const std::string numbers = envelope_chart(verdict, signal::Defect::none).numbers;
  EXPECT_THAT(numbers, HasSubstr("\"lowest\":-10,\"highest\":22,\"step\":2,"));
  EXPECT_THAT(numbers, HasSubstr("0,0,200,0,0,0,0,0,0,0,0,0,-100,0,0"));
}

}  // namespace
}  // namespace piae::classification
