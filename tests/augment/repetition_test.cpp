#include <algorithm>
#include <map>

#include "augment/methods.hpp"

namespace piae::augment {
namespace {

using Samples = std::vector<float>;

/// Returns two known windows of class IR and one of class OR; all circular shifts differ.
signal::WindowSet three_windows() {
  signal::WindowSet known;
  known.info = known_windows().info;
  known.length = 4;
  known.samples = {1, 2, 3, 4, 5, 6, 7, 8, 10, 20, 30, 40};
  known.labels = {1, 1, 2};
  return known;
}

signal::WindowSet windows_of(const std::string& method, std::size_t count) {
  const auto model = train(method, "", three_windows(), checkpoint_at("checkpoint"), "model.h5");
  return generate(method, model, count);
}

Samples window(const signal::WindowSet& set, std::size_t i) {
  return {set.window(i).begin(), set.window(i).end()};
}

TEST(Oversample, RepeatsTheKnownWindowsInTurn) {
  EXPECT_EQ(windows_of("oversample", 3).samples,
            (Samples{1,  2,  3,  4,  5,  6,  7,  8,  1,  2,  3,  4,  //
                     10, 20, 30, 40, 10, 20, 30, 40, 10, 20, 30, 40}));
}

TEST(Oversample, RecordsWhichWindowItRepeats) {
  EXPECT_EQ(windows_of("oversample", 3).parents,
            (std::vector<signal::Parents>{{0}, {1}, {0}, {2}, {2}, {2}}));
}

TEST(Shift, RecordsWhichWindowItShifts) {
  const signal::WindowSet known = three_windows();
  const signal::WindowSet windows = windows_of("shift", 5);
  ASSERT_EQ(windows.parents.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    ASSERT_EQ(windows.parents[i].size(), 1U) << i;
    Samples turned = window(windows, i);
    std::ranges::sort(turned);
    EXPECT_EQ(turned, window(known, static_cast<std::size_t>(windows.parents[i][0]))) << i;
  }
}

TEST(Shift, ShiftsKnownWindowsCircularlyAtRandom) {
  const signal::WindowSet windows = windows_of("shift", 8);
  const Samples known[] = {{1, 2, 3, 4}, {5, 6, 7, 8}};
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t shift = Stream("generate/IR/" + std::to_string(i)).below(4);
    Samples expected;
    for (std::size_t t = 0; t < 4; ++t) expected.push_back(known[i % 2][(t + shift) % 4]);
    EXPECT_EQ(window(windows, i), expected) << i;
  }
}

TEST(Shift, MakesEveryShiftEquallyOften) {
  const signal::WindowSet windows = windows_of("shift", 400);
  std::map<float, int> firsts;  // for class OR, which has one known window
  for (std::size_t i = 400; i < 800; ++i) ++firsts[windows.window(i)[0]];
  ASSERT_EQ(firsts.size(), 4U);
  for (const auto& [first, times] : firsts) {
    EXPECT_NEAR(times, 100, 29) << first;  // 3.3 standard deviations of 8.7
  }
}

}  // namespace
}  // namespace piae::augment
