#include <algorithm>

#include "augment/interpolation.hpp"
#include "augment/methods.hpp"
#include "base/error.hpp"

namespace piae::augment {
namespace {

/// Returns class IR: (0, 0), (2, 0), (0, 3), (4, 3), the windows of interpolation_test.cpp. Class
/// OR lies between them, so that neighbours across classes would show. A third sample, the same in
/// all windows, prevents constant windows.
signal::WindowSet four_of_a_class() {
  signal::WindowSet known;
  known.info = known_windows().info;
  known.length = 3;
  known.samples = {0, 0, 1.5, 2, 0, 1.5, 0, 3, 1.5, 4, 3, 1.5,
                   1, 1, 1.5, 1, 2, 1.5, 2, 1, 1.5, 2, 2, 1.5};
  known.labels = {1, 1, 1, 1, 2, 2, 2, 2};
  return known;
}

std::filesystem::path model_with(int neighbours) {
  return train("smote", "--neighbours " + std::to_string(neighbours), four_of_a_class(),
               checkpoint_at("checkpoint"), "model.h5");
}

/// Returns the position of a window between base (0) and neighbour (1), from the coordinate that
/// differs most; fails the test if the window is not on that line.
double place_between(Window base, Window neighbour, Window window) {
  const std::size_t t = std::abs(neighbour[0] - base[0]) > std::abs(neighbour[1] - base[1]) ? 0 : 1;
  const double gap = (window[t] - base[t]) / (neighbour[t] - base[t]);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_NEAR(window[s], base[s] + gap * (neighbour[s] - base[s]), 1e-6);
  }
  return gap;
}

TEST(Smote, WithOneNeighbourInterpolatesToTheNearest) {
  // From the table by hand: (0,0) -> (2,0), (2,0) -> (0,0), (0,3) -> (0,0), (4,3) -> (2,0). The
  // known windows take turns as the base.
  const std::size_t nearest[] = {1, 0, 0, 1};
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(1), 400);
  std::vector<double> gaps;
  for (std::size_t i = 0; i < 400; ++i) {
    gaps.push_back(
        place_between(known.window(i % 4), known.window(nearest[i % 4]), windows.window(i)));
  }
  std::ranges::sort(gaps);
  // Uniform in [0, 1): the Kolmogorov distance of 400 numbers is below 0.0979 in 99.9 % of cases.
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    EXPECT_NEAR(gaps[i], static_cast<double>(i) / 400, 0.0979);
  }
  EXPECT_GE(gaps.front(), 0);
  EXPECT_LT(gaps.back(), 1);
}

TEST(Smote, DrawsEveryNeighbourAndNoOtherWindow) {
  // The two nearest of (0, 0) are (2, 0) and (0, 3): windows lie on one axis or the other.
  const signal::WindowSet windows = generate("smote", model_with(2), 400);
  int along_first = 0;
  for (std::size_t i = 0; i < 400; i += 4) {
    const Window window = windows.window(i);
    EXPECT_EQ(std::min(window[0], window[1]), 0);
    EXPECT_LT(window[0], 2);
    EXPECT_LT(window[1], 3);
    if (window[0] > 0) ++along_first;
  }
  EXPECT_NEAR(along_first, 50, 17);  // of 100; 3.3 standard deviations
}

TEST(Smote, FollowsItsRandomNumbersExactly) {
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(3), 6);
  // Window 5 of class IR: base (2, 0), with neighbours by distance (0,0), (0,3), (4,3).
  Stream random("generate/IR/5");
  const float neighbours[3][2] = {{0, 0}, {0, 3}, {4, 3}};
  const float* neighbour = neighbours[random.below(3)];
  const double gap = random.uniform(0, 1);
  EXPECT_EQ(windows.window(5)[0], static_cast<float>(2 + gap * (neighbour[0] - 2)));
  EXPECT_EQ(windows.window(5)[1], static_cast<float>(gap * neighbour[1]));
}

TEST(Smote, RecordsBothParentsOfEachWindow) {
  const signal::WindowSet known = four_of_a_class();
  const signal::WindowSet windows = generate("smote", model_with(3), 40);
  ASSERT_EQ(windows.parents.size(), 80U);
  for (std::size_t i = 0; i < 80; ++i) {
    ASSERT_EQ(windows.parents[i].size(), 2U) << i;
    const auto base = static_cast<std::size_t>(windows.parents[i][0]);
    const auto neighbour = static_cast<std::size_t>(windows.parents[i][1]);
    EXPECT_EQ(base, i % 40 % 4 + i / 40 * 4);
    EXPECT_EQ(known.labels[neighbour], windows.labels[i]);
    const double gap =
        place_between(known.window(base), known.window(neighbour), windows.window(i));
    EXPECT_GE(gap, 0);
    EXPECT_LT(gap, 1);
  }
}

TEST(Smote, StaysWithinTheClass) {
  const signal::WindowSet windows = generate("smote", model_with(3), 100);
  for (std::size_t i = 100; i < 200; ++i) {
    for (const float sample : windows.window(i)) {
      EXPECT_GE(sample, 1);
      EXPECT_LE(sample, 2);
    }
  }
}

void expect_refusal(const signal::WindowSet& known, int neighbours,
                    const std::vector<std::string>& words) {
  try {
    train("smote", "--neighbours " + std::to_string(neighbours), known, checkpoint_at("checkpoint"),
          "never.h5");
    FAIL() << "took " << neighbours << " neighbours";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  }
}

TEST(Smote, NamesTheLargestPossibleNeighbours) {
  expect_refusal(four_of_a_class(), 4,
                 {"--neighbours 4", "IR", "4 known windows", "at most --neighbours 3"});
  signal::WindowSet uneven = four_of_a_class();
  uneven.samples.resize(18);
  uneven.labels.resize(6);
  expect_refusal(uneven, 3, {"--neighbours 3", "OR", "2 known windows", "at most --neighbours 1"});
}

TEST(Smote, NeedsTwoKnownWindows) {
  signal::WindowSet known = four_of_a_class();
  known.samples.resize(15);
  known.labels.resize(5);
  expect_refusal(known, 1, {"OR", "1 known window;", "at least 2"});
}

TEST(Smote, RefusesZeroNeighbours) {
  EXPECT_THROW(method_with("smote", "--neighbours 0"), cli::Refused);
  EXPECT_THROW(method_with("smote", "--neighbours 1.5"), cli::Refused);
}

}  // namespace
}  // namespace piae::augment
