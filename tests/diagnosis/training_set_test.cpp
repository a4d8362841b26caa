#include "diagnosis/training_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "diagnosis/sets.hpp"
#include "support/errors.hpp"

namespace piae::diagnosis {
namespace {

using signal::WindowSet;
using testing::HasSubstr;

class TrainingSet : public testing::Test {
 protected:
  TrainingSet() {
    add(normal, 0, 6, 100);
    add(known, 1, 2, 200);
    add(known, 2, 2, 300);
    // Labels of E alternate: "the first n of a class" are not the first n windows.
    for (std::size_t i = 0; i < 3; ++i) {
      add(generated, 2, 1, 500 + static_cast<float>(i));
      add(generated, 1, 1, 400 + static_cast<float>(i));
    }
    add(test, 0, 1, 1);
    add(test, 1, 1, 1);
    add(test, 2, 1, 1);
  }

  void expect_error(Exit exit, const std::string& part, const WindowSet* e, std::int64_t n) const {
    try {
      compose_training_set(normal, known, e, n);
      FAIL() << "no error with " << part;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), exit);
      EXPECT_THAT(error.what(), HasSubstr(part));
    }
  }

  WindowSet normal = empty_set(4);
  WindowSet known = empty_set(4);
  WindowSet generated = empty_set(4);
  WindowSet test = empty_set(4);
};

std::vector<float> first_samples(const WindowSet& set) {
  std::vector<float> firsts;
  for (std::size_t i = 0; i < set.size(); ++i) firsts.push_back(set.window(i)[0]);
  return firsts;
}

TEST_F(TrainingSet, HoldsHealthyAndKnownWindows) {
  const WindowSet set = compose_training_set(normal, known, nullptr, 0);
  EXPECT_THAT(first_samples(set),
              testing::ElementsAre(100, 101, 102, 103, 104, 105, 200, 201, 300, 301));
  EXPECT_THAT(set.labels, testing::ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 2, 2));
}

TEST_F(TrainingSet, HoldsTheFirstGeneratedWindowsOfEachClass) {
  const WindowSet set = compose_training_set(normal, known, &generated, 2);
  EXPECT_EQ(set.size(), 14U);
  EXPECT_EQ(set.samples.size(), 14U * 4);
  const std::vector<float> firsts = first_samples(set);
  EXPECT_THAT(std::vector(firsts.begin() + 10, firsts.end()),
              testing::ElementsAre(400, 401, 500, 501));
  EXPECT_THAT(std::vector(set.labels.begin() + 10, set.labels.end()),
              testing::ElementsAre(1, 1, 2, 2));
}

TEST_F(TrainingSet, NeedsGeneratedWindowsOnlyIfTheRatioUsesThem) {
  expect_error(Exit::usage, "--generated is missing, but the ratio needs 2", nullptr, 2);
  expect_error(Exit::usage, "--generated: this ratio does not use generated windows", &generated,
               0);
}

TEST_F(TrainingSet, HasTheRecordedSpeedOfEachWindow) {
  normal.shaft_speed_rpm = {600, 600, 600, 900, 900, 900};
  known.shaft_speed_rpm = {900, 600, 900, 600};
  generated.shaft_speed_rpm = {1, 2, 3, 4, 5, 6};
  EXPECT_THAT(compose_training_set(normal, known, &generated, 1).shaft_speed_rpm,
              testing::ElementsAre(600, 600, 600, 900, 900, 900, 900, 600, 900, 600, 2, 1));
  generated.shaft_speed_rpm.clear();
  EXPECT_THAT(compose_training_set(normal, known, &generated, 1).shaft_speed_rpm,
              testing::ElementsAre(600, 600, 600, 900, 900, 900, 900, 600, 900, 600,
                                   testing::IsNan(), testing::IsNan()));
}

// A generator that knows one speed of a class makes windows of that speed, whatever is tested.
TEST_F(TrainingSet, GivesGeneratedWindowsWithoutSpeedAndParentsThatOfTheirClass) {
  normal.shaft_speed_rpm = {600, 600, 600, 900, 900, 900};
  normal.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900},
                            {.name = "600 rpm", .shaft_speed_rpm = 600}};
  const auto speeds_for = [&](const std::vector<double>& of_known) {
    known.shaft_speed_rpm = of_known;
    const WindowSet set = compose_training_set(normal, known, &generated, 1);
    return std::vector<double>{set.speed_rpm(10), set.speed_rpm(11)};
  };
  EXPECT_THAT(speeds_for({900, 900, 900, 900}), testing::ElementsAre(900, 900));
  EXPECT_THAT(speeds_for({900, 910, 600, 606}), testing::ElementsAre(900, 600));
  // The records of one condition may differ by 10 %.
  EXPECT_THAT(speeds_for({900, 960, 600, 600}), testing::ElementsAre(930, 600));
  EXPECT_THAT(speeds_for({900, 600, 600, 600}), testing::ElementsAre(testing::IsNan(), 600));
  known = empty_set(4);
  const WindowSet set = compose_training_set(normal, known, &generated, 1);
  EXPECT_TRUE(std::isnan(set.speed_rpm(set.size() - 1)));
}

// The first windows of classes 1 and 2 in E are its windows 1 and 0.
TEST_F(TrainingSet, GivesGeneratedWindowsWithoutSpeedThatOfTheirParents) {
  normal.shaft_speed_rpm = {600, 600, 600, 900, 900, 900};
  known.shaft_speed_rpm = {900, 600, 908, 600};
  const auto speeds_of = [&](const signal::Parents& of_2, const signal::Parents& of_1) {
    generated.parents.assign(6, {0});
    generated.parents[0] = of_2;
    generated.parents[1] = of_1;
    const WindowSet set = compose_training_set(normal, known, &generated, 1);
    return std::vector<double>{set.speed_rpm(10), set.speed_rpm(11)};
  };
  EXPECT_THAT(speeds_of({3}, {0, 2}), testing::ElementsAre(900, 600));
  EXPECT_THAT(speeds_of({2, 3}, {}), testing::ElementsAre(testing::IsNan(), testing::IsNan()));
  known.shaft_speed_rpm = {900, 600, 960, 600};  // one condition, whose speeds may differ by 10 %
  EXPECT_THAT(speeds_of({3}, {0, 2}), testing::ElementsAre(930, 600));
  generated.parents[1] = {4};
  expect_error(Exit::bad_input,
               "--generated: a window was made from known window 4, but --known holds 4 windows",
               &generated, 1);
  generated.shaft_speed_rpm = {1, 2, 3, 4, 5, 6};
  EXPECT_THAT(speeds_of({3}, {0}), testing::ElementsAre(2, 1));
}

TEST_F(TrainingSet, GivesGeneratedWindowsWithoutSpeedTheOnlySpeed) {
  const auto speed_of_generated = [&] {
    const WindowSet set = compose_training_set(normal, known, &generated, 1);
    return set.speed_rpm(set.size() - 1);
  };
  EXPECT_EQ(speed_of_generated(), 1800);  // speed of the data set, if windows record none
  normal.shaft_speed_rpm.assign(6, 900);
  known.shaft_speed_rpm.assign(4, 900);
  normal.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900}};
  EXPECT_EQ(speed_of_generated(), 900);
  // A machine's speed varies slightly between records: 2 % count as one speed.
  known.shaft_speed_rpm = {900, 902, 910, 905};
  EXPECT_EQ(speed_of_generated(), 905);
  known.shaft_speed_rpm = {900, 902, 925, 905};
  EXPECT_EQ(speed_of_generated(), 915);  // the middle of its class
}

TEST_F(TrainingSet, RefusesTooFewGeneratedWindows) {
  expect_error(Exit::bad_input, "--generated: holds 3 windows of class 'IR', but the ratio needs 4",
               &generated, 4);
}

TEST_F(TrainingSet, NeedsEachClassInItsSetOnly) {
  const WindowSet good_known = known;
  known = empty_set(4);
  add(known, 1, 2, 0);
  expect_error(Exit::bad_input, "--known: has no window of class 'OR'", nullptr, 0);

  known = good_known;
  add(known, 0, 1, 0);
  expect_error(Exit::bad_input, "--known: holds windows of class 'Normal'", nullptr, 0);

  std::swap(normal, known = good_known);
  expect_error(Exit::bad_input, "--normal: has no window of class 'Normal'", nullptr, 0);
}

TEST_F(TrainingSet, RefusesSetsOfDifferentOrigin) {
  const WindowSet good_known = known;
  known.info.name = "cwru";
  expect_error(Exit::bad_input, "--known: is of data set cwru, but --normal has toy", nullptr, 0);

  known = good_known;
  known.info.classes[1].name = "IR007";
  expect_error(Exit::bad_input, "--known: has class 1 IR007, but --normal has IR", nullptr, 0);

  known = good_known;
  known.info.classes.pop_back();
  expect_error(Exit::bad_input, "--known: has the number of classes 2", nullptr, 0);

  known = good_known;
  generated.length = 2;
  expect_error(Exit::bad_input, "--generated: has windows of length 2, but --normal has 4",
               &generated, 1);
}

TEST_F(TrainingSet, NeedsATestSetWithEveryClass) {
  const WindowSet training = compose_training_set(normal, known, nullptr, 0);
  EXPECT_NO_THROW(require_fitting_test_set(test, training));
  WindowSet lacking = empty_set(4);
  add(lacking, 0, 1, 1);
  add(lacking, 1, 1, 1);
  EXPECT_THROW(require_fitting_test_set(lacking, training), Error);
  test.info.sample_rate_hz = 48000;
  EXPECT_THROW(require_fitting_test_set(test, training), Error);
}

TEST_F(TrainingSet, DoesNotNeedKnownFaultsIfSomeAreGenerated) {
  const WindowSet nothing = empty_set(4);
  const WindowSet set = compose_training_set(normal, nothing, &generated, 1);
  EXPECT_THAT(first_samples(set), testing::ElementsAre(100, 101, 102, 103, 104, 105, 400, 500));
  const Classifier network{.name = "network", .what = "", .input = ""};
  const Classifier rule{.name = "rule", .what = "", .input = "", .rule = true};
  EXPECT_NO_THROW(require_faults(set, network, "C.h5"));
  const WindowSet healthy_alone = compose_training_set(normal, nothing, nullptr, 0);
  EXPECT_EQ(healthy_alone.size(), normal.size());
  EXPECT_NO_THROW(require_faults(healthy_alone, rule, "C.h5"));
  EXPECT_ERROR(require_faults(healthy_alone, network, "C.h5"), Exit::bad_input,
               "C.h5: has no known fault windows (known-per-class = 0), and network cannot learn "
               "faults without any; give --generated windows");
}

TEST_F(TrainingSet, RefusesKnownFaultsOfSomeClassesOnly) {
  known = empty_set(4);
  add(known, 1, 2, 200);
  expect_error(Exit::bad_input, "--known: has no window of class", nullptr, 0);
}

TEST_F(TrainingSet, TakesTheFirstGeneratedWindowsOfEachClassInOrder) {
  EXPECT_THAT(first_of_each_fault(generated, 2), testing::ElementsAre(1, 3, 0, 2));
  EXPECT_THAT(first_of_each_fault(generated, 9), testing::ElementsAre(1, 3, 5, 0, 2, 4));
  EXPECT_THAT(first_of_each_fault(generated, 0), testing::ElementsAre());
}

}  // namespace
}  // namespace piae::diagnosis
