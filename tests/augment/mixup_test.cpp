#include "augment/mixup.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <map>

#include "augment/methods.hpp"
#include "augment/places.hpp"
#include "support/errors.hpp"

namespace piae::augment {
namespace {

using Samples = std::vector<float>;

signal::WindowSet mixed(const std::string& method, const std::string& options,
                        const signal::WindowSet& known, std::size_t count) {
  return generate(method, train(method, options, known, checkpoint_at("checkpoint"), "model.h5"),
                  count);
}

/// Returns lambda of windows of class IR, which has known windows at 0 and 1.
std::vector<double> weights_with(const std::string& options, std::size_t count) {
  const signal::WindowSet known = at_places({{1, 0}, {1, 1}, {2, 5}, {2, 6}});
  const signal::WindowSet windows = mixed("mixup", options, known, count);
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = windows.window(i)[0];
    weights.push_back(i % 2 == 0 ? 1 - place : place);
  }
  return weights;
}

TEST(Mixup, DrawsItsWeightsFromABetaDistribution) {
  for (const double alpha : {0.2, 1.0, 5.0}) {
    std::vector<double> weights = weights_with("--alpha " + std::to_string(alpha), 4000);
    const auto n = static_cast<double>(weights.size());
    double mean = 0;
    double variance = 0;
    for (const double weight : weights) {
      mean += weight / n;
      variance += std::pow(weight - 0.5, 2) / n;
    }
    const double expected = 1 / (4 * (2 * alpha + 1));
    EXPECT_NEAR(mean, 0.5, 4 * std::sqrt(expected / n)) << alpha;
    EXPECT_NEAR(variance, expected, 4 * 0.125 / std::sqrt(n)) << alpha;
    std::ranges::sort(weights);
    // The Kolmogorov distance of 4000 numbers is below 0.031 in 99.9 % of cases.
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double below = boost::math::ibeta(alpha, alpha, std::clamp(weights[i], 0.0, 1.0));
      ASSERT_NEAR(below, static_cast<double>(i) / n, 0.031) << alpha;
    }
  }
}

TEST(Mixup, TakesAnAlphaOf0Point2ByDefault) {
  EXPECT_EQ(weights_with("", 50), weights_with("--alpha 0.2", 50));
}

TEST(Mixup, FollowsItsRandomNumbersExactly) {
  const signal::WindowSet known = known_at_places();
  const signal::WindowSet windows = mixed("mixup", "", known, 7);
  // Window 6 of class IR starts at its third known one; the others are 0, 1 and 9.
  Stream random("generate/IR/6");
  const double other = std::vector<double>{0, 1, 9}[random.below(3)];
  const double weight = random.beta(0.2, 0.2);
  EXPECT_FLOAT_EQ(windows.window(6)[0], static_cast<float>(weight * 3 + (1 - weight) * other));
  EXPECT_EQ(windows.window(6)[1], 0.5F);
}

TEST(Mixup, DrawsEveryPairOfAClassEquallyOften) {
  constexpr std::size_t count = 2400;
  for (const std::string method : {"mixup", "aligned-mixup"}) {
    const signal::WindowSet windows = mixed(method, "", known_at_places(), count);
    std::map<signal::Parents, int> pairs;
    for (std::size_t i = 0; i < count; ++i) {
      signal::Parents parents = windows.parents[i];
      EXPECT_EQ(std::ranges::count(parents, static_cast<std::int32_t>(i % 4)), 1) << i;
      std::ranges::sort(parents);
      ++pairs[parents];
    }
    ASSERT_EQ(pairs.size(), 6U);
    for (const auto& [pair, times] : pairs) EXPECT_NEAR(times, 400, 75);  // 4 standard deviations
  }
}

TEST(Mixup, NamesTheParentOfTheLargerPartFirst) {
  const signal::WindowSet known = known_at_places();
  const signal::WindowSet windows = mixed("mixup", "", known, 60);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto from = [&](std::size_t rank) {
      const auto parent = static_cast<std::size_t>(windows.parents[i].at(rank));
      return std::abs(windows.window(i)[0] - known.window(parent)[0]);
    };
    EXPECT_LE(from(0), from(1)) << i;
  }
}

/// Returns the shift with the largest correlation by its definition.
std::size_t best_shift(const Samples& reference, const Samples& window) {
  std::size_t best = 0;
  double largest = -1e300;
  for (std::size_t s = 0; s < window.size(); ++s) {
    double sum = 0;
    for (std::size_t t = 0; t < window.size(); ++t) {
      sum += static_cast<double>(reference[t]) * window[(t + s) % window.size()];
    }
    if (sum > largest) best = s;
    largest = std::max(largest, sum);
  }
  return best;
}

double mean_square(const Samples& window) {
  double sum = 0;
  for (const float sample : window) sum += static_cast<double>(sample) * sample;
  return sum / static_cast<double>(window.size());
}

Samples noise(std::size_t length, double level, Stream& random) {
  Samples window(length);
  for (float& sample : window) sample = static_cast<float>(random.normal(0.3, level));
  return window;
}

TEST(AlignedTo, ShiftsToTheLargestCorrelationAndMatchesTheLevel) {
  Stream random("aligned");
  for (const std::size_t length : {2, 3, 50, 51}) {
    const Samples reference = noise(length, 2, random);
    Samples window = noise(length, 7, random);
    const Samples aligned = aligned_to(reference, window);
    const std::size_t shift = best_shift(reference, window);
    std::rotate(window.begin(), window.begin() + static_cast<std::ptrdiff_t>(shift), window.end());
    const double gain = std::sqrt(mean_square(reference) / mean_square(window));
    for (std::size_t t = 0; t < length; ++t) {
      EXPECT_NEAR(aligned[t], gain * window[t], 1e-5) << length << ", " << t;
    }
    EXPECT_NEAR(mean_square(aligned), mean_square(reference), 1e-5);
  }
}

/// Returns known windows that are circular shifts of one window of their class, at several levels.
signal::WindowSet shifts_of_one() {
  signal::WindowSet known = known_windows();
  Stream random("shifts");
  for (const Label label : {1, 2}) {
    const Samples base = noise(known.length, 1, random);
    for (const std::size_t i : known.indices_of(label)) {
      const std::size_t shift = random.below(known.length);
      for (std::size_t t = 0; t < known.length; ++t) {
        known.samples[i * known.length + t] =
            static_cast<float>(i + 1) * base[(t + shift) % known.length];
      }
    }
  }
  return known;
}

TEST(AlignedMixup, OfShiftedCopiesIsTheFirstWindow) {
  const signal::WindowSet known = shifts_of_one();
  const signal::WindowSet windows = mixed("aligned-mixup", "--alpha 1", known, 20);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Window expected = known.window(i % 20 % 5 + i / 20 * 5);
    for (std::size_t t = 0; t < known.length; ++t) {
      ASSERT_NEAR(windows.window(i)[t], expected[t], 1e-4) << i;
    }
  }
}

TEST(AlignedMixup, MixesWithTheAlignedWindow) {
  const signal::WindowSet known = known_windows();
  const signal::WindowSet windows = mixed("aligned-mixup", "", known, 9);
  // Window 8 of class OR starts at its fourth known one.
  Stream random("generate/OR/8");
  const std::size_t other = std::vector<std::size_t>{5, 6, 7, 9}[random.below(4)];
  const double weight = random.beta(0.2, 0.2);
  const auto samples_of = [&](std::size_t i) {
    return Samples(known.window(i).begin(), known.window(i).end());
  };
  const Samples base = samples_of(8);
  const Samples partner = samples_of(other);
  const std::size_t shift = best_shift(base, partner);
  const double gain = std::sqrt(mean_square(base) / mean_square(partner));
  for (std::size_t t = 0; t < known.length; ++t) {
    const double aligned = gain * partner[(t + shift) % known.length];
    EXPECT_NEAR(windows.window(9 + 8)[t], weight * base[t] + (1 - weight) * aligned, 1e-5) << t;
  }
}

TEST(Mixup, NeedsTwoKnownWindowsOfEachClass) {
  const signal::WindowSet known = at_places({{1, 0}, {1, 1}, {2, 5}});
  for (const std::string method : {"mixup", "aligned-mixup"}) {
    EXPECT_ERROR(mixed(method, "", known, 1), Exit::bad_input,
                 "class OR has 1 known window, but mixup needs 2; split with --known-per-class 2");
  }
}

TEST(Mixup, RefusesAnAlphaOutOfBounds) {
  EXPECT_THROW(method_with("mixup", "--alpha 0"), cli::Refused);
  EXPECT_THROW(method_with("mixup", "--alpha 0.04"), cli::Refused);
  EXPECT_THROW(method_with("mixup", "--alpha 101"), cli::Refused);
  EXPECT_THROW(method_with("mixup", "--alpha nan"), cli::Refused);
}

/// Returns a model such as no training writes.
std::filesystem::path damaged(const signal::WindowSet& known, double alpha) {
  artefact::Writer writer("model");
  signal::write(writer, known);
  writer.group("/mixup");
  writer.attribute("/mixup", "alpha", alpha);
  std::filesystem::path path = scratch_file("damaged.h5");
  writer.save(path, {});
  return path;
}

TEST(Mixup, RefusesADamagedModel) {
  EXPECT_ERROR(generate("mixup", damaged(known_at_places(), 0), 1), Exit::bad_input, "alpha");
  EXPECT_ERROR(generate("mixup", damaged(at_places({{1, 0}, {1, 1}, {2, 5}}), 1), 1),
               Exit::bad_input, "has 1 window of class OR, but mixup needs 2");
  EXPECT_EQ(generate("mixup", damaged(known_at_places(), 1), 1).size(), 2U);
}

}  // namespace
}  // namespace piae::augment
