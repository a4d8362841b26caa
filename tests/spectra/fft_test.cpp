#include "spectra/fft.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace piae::spectra {
namespace {

using Complex = std::complex<double>;

/// Returns numbers without a pattern that a transform could exploit.
template <class T>
std::vector<T> irregular(std::size_t count) {
  std::vector<T> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<double>(i);
    numbers[i] = static_cast<T>(std::sin(n * n * 0.7) + 0.3 * std::cos(1.9 * n));
  }
  return numbers;
}

/// Computes the transform by its definition, a sum per bin. The sign is -1 for the transform and 1
/// for its inverse without 1/N.
template <class T>
std::vector<Complex> by_definition(const std::vector<T>& values, double sign) {
  const auto length = static_cast<double>(values.size());
  std::vector<Complex> sums(values.size());
  for (std::size_t k = 0; k < sums.size(); ++k) {
    for (std::size_t n = 0; n < values.size(); ++n) {
      const double turns =
          std::fmod(static_cast<double>(k) * static_cast<double>(n), length) / length;
      sums[k] += Complex(values[n]) * std::polar(1.0, sign * 2 * std::numbers::pi * turns);
    }
  }
  return sums;
}

// Multiples of four, which Eigen treats specially; other even lengths; odd lengths; a prime.
class Fft : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Lengths, Fft, testing::Values(2, 3, 4, 12, 15, 30, 97, 1024));

TEST_P(Fft, RealTransformIsHalfOfTheDefinition) {
  const std::vector<double> samples = irregular<double>(GetParam());
  std::vector<Complex> bins(samples.size() / 2 + 1);
  fft(samples, bins);
  const std::vector<Complex> expected = by_definition(samples, -1);
  for (std::size_t k = 0; k < bins.size(); ++k)
    EXPECT_LT(std::abs(bins[k] - expected[k]), 1e-10) << k;

  std::vector<double> back(samples.size());
  inverse_fft(bins, back);
  EXPECT_THAT(back, testing::Pointwise(testing::DoubleNear(1e-12), samples));
}

TEST_P(Fft, SinglePrecisionMatchesDouble) {
  const std::vector<float> samples = irregular<float>(GetParam());
  std::vector<std::complex<float>> bins(samples.size() / 2 + 1);
  fft(samples, bins);
  const std::vector<Complex> expected = by_definition(samples, -1);
  for (std::size_t k = 0; k < bins.size(); ++k)
    EXPECT_LT(std::abs(Complex(bins[k]) - expected[k]), 1e-3) << k;

  std::vector<float> back(samples.size());
  inverse_fft(bins, back);
  EXPECT_THAT(back, testing::Pointwise(testing::FloatNear(1e-5F), samples));
}

TEST_P(Fft, ComplexTransformMatchesTheDefinitionBothWays) {
  std::vector<Complex> samples(GetParam());
  const std::vector<double> parts = irregular<double>(2 * samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) samples[n] = {parts[2 * n], parts[2 * n + 1]};
  std::vector<Complex> bins(samples.size());
  fft(samples, bins);
  std::vector<Complex> inverse(samples.size());
  inverse_fft(samples, inverse);
  const std::vector<Complex> forward = by_definition(samples, -1);
  const std::vector<Complex> backward = by_definition(samples, 1);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    EXPECT_LT(std::abs(bins[k] - forward[k]), 1e-10) << k;
    EXPECT_LT(std::abs(inverse[k] - backward[k] / static_cast<double>(samples.size())), 1e-12) << k;
  }
}

TEST(FftLengths, RefuseMismatchedLengths) {
  std::vector<double> samples(8);
  std::vector<Complex> bins(4);
  EXPECT_THROW(fft(samples, bins), std::logic_error);
  EXPECT_THROW(inverse_fft(bins, samples), std::logic_error);
  for (const std::size_t too_few : {0U, 1U}) {
    std::vector<double> none(too_few);
    std::vector<Complex> bin(too_few / 2 + 1);
    EXPECT_THROW(fft(none, bin), std::logic_error) << too_few;
    EXPECT_THROW(inverse_fft(bin, none), std::logic_error) << too_few;
  }
  const std::vector<Complex> fewer(3);
  EXPECT_THROW(fft(fewer, bins), std::logic_error);
}

}  // namespace
}  // namespace piae::spectra
