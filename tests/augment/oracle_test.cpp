#include <set>

#include "augment/methods.hpp"
#include "base/error.hpp"

namespace piae::augment {
namespace {

/// Makes 30 real windows of each fault class in order of time; each begins with its own number.
signal::WindowSet numbered_windows() {
  signal::WindowSet real;
  real.info = known_windows().info;
  real.length = 2;
  for (int i = 0; i < 60; ++i) {
    real.samples.insert(real.samples.end(), {static_cast<float>(i), 0.5F});
    real.labels.push_back(i < 30 ? 1 : 2);
  }
  return real;
}

std::filesystem::path model() {
  return train("oracle", "", numbered_windows(), checkpoint_at("checkpoint"), "model.h5");
}

std::vector<int> numbers_of(const signal::WindowSet& windows, std::int32_t label) {
  std::vector<int> numbers;
  for (const std::size_t i : windows.indices_of(label)) {
    numbers.push_back(static_cast<int>(windows.window(i)[0]));
  }
  return numbers;
}

TEST(Oracle, IsTheOnlyMethodThatLearnsFromRealWindows) {
  for (const std::string& name : method_names()) {
    const LearnsFrom from = make_method(name)->learns_from();
    EXPECT_EQ(from, name == "oracle" ? LearnsFrom::real : LearnsFrom::known) << name;
  }
}

TEST(Oracle, TakesEachWindowOnceAndOfItsOwnClass) {
  const signal::WindowSet all = generate("oracle", model(), 30);
  for (const int label : {1, 2}) {
    const std::vector<int> numbers = numbers_of(all, label);
    const std::set<int> different(numbers.begin(), numbers.end());
    EXPECT_EQ(different.size(), 30U);
    EXPECT_EQ(*different.begin(), 30 * (label - 1));
    EXPECT_EQ(*different.rbegin(), 30 * label - 1);
  }
  EXPECT_TRUE(all.record.empty());
}

/// A blocked D is in order of time, so its first windows are one stretch of the record.
TEST(Oracle, TakesThemFromAllOverTheRecord) {
  std::vector<int> first = numbers_of(generate("oracle", model(), 5), 1);
  std::ranges::sort(first);
  EXPECT_GT(first.back() - first.front(), 10);
}

TEST(Oracle, FirstWindowsDoNotDependOnTheCount) {
  const std::vector<int> few = numbers_of(generate("oracle", model(), 4), 2);
  std::vector<int> many = numbers_of(generate("oracle", model(), 20), 2);
  many.resize(4);
  EXPECT_EQ(many, few);
}

/// Some classifiers measure a window at its own shaft speed.
TEST(Oracle, HasTheRecordedSpeedOfEachWindow) {
  signal::WindowSet real = numbered_windows();
  for (std::size_t i = 0; i < real.size(); ++i) {
    real.shaft_speed_rpm.push_back(600 + real.window(i)[0]);
  }
  const signal::WindowSet taken =
      generate("oracle", train("oracle", "", real, checkpoint_at("checkpoint"), "model.h5"), 30);
  ASSERT_EQ(taken.shaft_speed_rpm.size(), 60U);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    EXPECT_EQ(taken.shaft_speed_rpm[i], 600 + taken.window(i)[0]);
  }
}

TEST(Oracle, NamesTheLargestPossibleCount) {
  try {
    generate("oracle", model(), 31);
    FAIL() << "made a real window";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_NE(std::string(error.what()).find("class IR has 30 real windows"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("give at most --count 30"), std::string::npos);
  }
}

}  // namespace
}  // namespace piae::augment
