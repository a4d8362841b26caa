#include "augment/spectral.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "augment/methods.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

/// Returns the spectrum up to half the sampling rate, by the definition of the transform.
std::vector<std::complex<double>> transform(Window window) {
  std::vector<std::complex<double>> spectrum;
  const auto length = static_cast<double>(window.size());
  for (std::size_t bin = 0; bin <= window.size() / 2; ++bin) {
    std::complex<double> sum;
    for (std::size_t t = 0; t < window.size(); ++t) {
      const double turns = static_cast<double>(bin * t % window.size()) / length;
      sum += static_cast<double>(window[t]) * std::polar(1.0, -2 * std::numbers::pi * turns);
    }
    spectrum.push_back(sum);
  }
  return spectrum;
}

signal::WindowSet spectral_windows(const std::string& options, const signal::WindowSet& known,
                                   std::size_t count) {
  const auto model = train("spectral", options, known, checkpoint_at("checkpoint"), "model.h5");
  return generate("spectral", model, count);
}

TEST(Spectral, KeepsTheAmplitudesWithoutAnEqualiser) {
  for (const std::size_t length : {64, 63}) {
    const signal::WindowSet known = known_windows(length);
    const signal::WindowSet windows = spectral_windows("--equaliser-db 0", known, 6);
    for (std::size_t i = 0; i < windows.size(); ++i) {
      const auto expected = transform(known.window(i % 6 % 5 + i / 6 * 5));
      const auto made = transform(windows.window(i));
      for (std::size_t bin = 0; bin < made.size(); ++bin) {
        EXPECT_NEAR(std::abs(made[bin]), std::abs(expected[bin]), 1e-4) << i << ", " << bin;
      }
      EXPECT_NEAR(made.front().real(), expected.front().real(), 1e-4);
      if (length % 2 == 0) {
        EXPECT_NEAR(made.back().real(), expected.back().real(), 1e-4);
      }
    }
  }
}

TEST(Spectral, DrawsPhasesUniformly) {
  const signal::WindowSet known = known_windows(16);
  const signal::WindowSet windows = spectral_windows("", known, 200);
  std::vector<double> phases;  // of bins 1 to 7
  std::complex<double> mean;   // of the difference between neighbouring bins
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto spectrum = transform(windows.window(i));
    for (std::size_t bin = 1; bin < 8; ++bin) phases.push_back(std::arg(spectrum[bin]));
    for (std::size_t bin = 1; bin < 7; ++bin) {
      mean += std::polar(1.0, std::arg(spectrum[bin + 1]) - std::arg(spectrum[bin]));
    }
  }
  std::ranges::sort(phases);
  const auto n = static_cast<double>(phases.size());
  // The Kolmogorov distance of 2800 numbers is below 0.0370 in 99.9 % of cases.
  for (std::size_t i = 0; i < phases.size(); ++i) {
    ASSERT_NEAR(phases[i] / (2 * std::numbers::pi) + 0.5, static_cast<double>(i) / n, 0.037);
  }
  EXPECT_LT(std::abs(mean) / 2400, 3 / std::sqrt(2400.0));
}

TEST(Spectral, FollowsItsRandomNumbersExactly) {
  const signal::WindowSet known = known_windows(16);
  const signal::WindowSet windows =
      spectral_windows("--equaliser-db 12 --equaliser-knots 3", known, 8);
  // Window 7 of class IR comes from its third known one. Knots lie at bins 0, 4 and 8.
  Stream random("generate/IR/7");
  auto expected = transform(known.window(2));
  for (std::size_t bin = 1; bin < 8; ++bin) {
    expected[bin] = std::polar(std::abs(expected[bin]), random.uniform(0, 2 * std::numbers::pi));
  }
  double knots_db[3];
  for (double& db : knots_db) db = random.normal(0, 12);
  for (std::size_t bin = 0; bin <= 8; ++bin) {
    const double part = static_cast<double>(bin % 4) / 4;
    const double db =
        bin == 8 ? knots_db[2] : (1 - part) * knots_db[bin / 4] + part * knots_db[bin / 4 + 1];
    expected[bin] *= std::pow(10, db / 20);
  }
  // Scaled to the mean square of the known window, by Parseval's theorem.
  const auto power = [](const std::vector<std::complex<double>>& spectrum) {
    double sum = std::norm(spectrum[0]) + std::norm(spectrum[8]);
    for (std::size_t bin = 1; bin < 8; ++bin) sum += 2 * std::norm(spectrum[bin]);
    return sum;
  };
  const double gain = std::sqrt(power(transform(known.window(2))) / power(expected));
  const auto made = transform(windows.window(7));
  for (std::size_t bin = 0; bin <= 8; ++bin) {
    EXPECT_NEAR(std::abs(made[bin] - gain * expected[bin]), 0, 1e-4) << bin;
  }
}

TEST(Spectral, TakesTheKnownWindowsInTurn) {
  EXPECT_EQ(
      spectral_windows("", known_windows(), 6).parents,
      (std::vector<signal::Parents>{{0}, {1}, {2}, {3}, {4}, {0}, {5}, {6}, {7}, {8}, {9}, {5}}));
}

TEST(Spectral, RefusesAnEqualiserOutOfBounds) {
  EXPECT_THROW(method_with("spectral", "--equaliser-db -1"), cli::Refused);
  EXPECT_THROW(method_with("spectral", "--equaliser-knots 1"), cli::Refused);
}

TEST(Spectral, RefusesADamagedModel) {
  artefact::Writer writer("model");
  signal::write(writer, known_windows());
  writer.group("/equaliser");
  writer.attribute("/equaliser", "spread_db", 6.0);
  writer.attribute("/equaliser", "knots", std::int64_t{1});
  writer.save(scratch_file("damaged.h5"), {});
  EXPECT_ERROR(generate("spectral", scratch_file("damaged.h5"), 1), Exit::bad_input, "knots");
}

}  // namespace
}  // namespace piae::augment
