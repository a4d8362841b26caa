#include "scoring/quality.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/random.hpp"
#include "bearing/impact_frequency.hpp"
#include "scoring/mmd.hpp"
#include "scoring/sets.hpp"
#include "support/fault_windows.hpp"
#include "support/three_classes.hpp"

namespace piae::scoring {
namespace {

using testing::HasSubstr;

signal::WindowSet empty_set() {
  signal::WindowSet set;
  set.info = three_classes();
  set.length = 4;
  return set;
}

/// Returns two windows of class IR and three of class OR.
signal::WindowSet real_set() {
  signal::WindowSet set = empty_set();
  add(set, 1, {1, 0, 0, 0});
  add(set, 2, {2, 0, 0, 1});
  add(set, 1, {0, 1, 0, 0});
  add(set, 2, {0, 2, 0, 1});
  add(set, 2, {0, 0, 2, 1});
  return set;
}

void expect_refused(const signal::WindowSet& generated, const signal::WindowSet& real,
                    const std::string& what) {
  try {
    quality_by_class(generated, real);
    ADD_FAILURE() << "not refused: " << what;
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::bad_input);
    EXPECT_THAT(error.what(), HasSubstr(what));
  }
}

TEST(QualityByClass, RealWindowsMatchThemselvesPerfectly) {
  const auto classes = quality_by_class(real_set(), real_set());
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].label, 1);
  EXPECT_EQ(classes[0].windows, 2);
  EXPECT_EQ(classes[1].label, 2);
  EXPECT_EQ(classes[1].windows, 3);
  for (const ClassQuality& quality : classes) {
    EXPECT_NEAR(quality.mmd, 0, 1e-12);
    EXPECT_EQ(quality.rmse, 0);
    EXPECT_EQ(quality.aligned_rmse, 0);
    EXPECT_EQ(quality.amplitude_ratio, 1);
    EXPECT_EQ(quality.spectral_distance_db, 0);
    EXPECT_EQ(quality.fault_line_difference_db, 0);
  }
}

TEST(QualityByClass, DefectOtherHasNoLine) {
  signal::WindowSet real = real_set();
  real.info.classes[2].defect = signal::Defect::other;
  signal::WindowSet louder = real;
  for (float& sample : louder.samples) sample *= sample;
  const auto classes = quality_by_class(louder, real);
  EXPECT_EQ(classes[1].fault_line_db, 0);
  EXPECT_EQ(classes[1].fault_line_difference_db, 0);
  EXPECT_GT(classes[1].rmse, 0);
}

TEST(QualityByClass, PairsTheFirstWindowsOfAClassInOrder) {
  signal::WindowSet generated = empty_set();
  add(generated, 2, {4, 0, 0, 1});  // against {2, 0, 0, 1}: RMSE 1
  add(generated, 1, {0, 1, 0, 0});  // against {1, 0, 0, 0}: RMSE sqrt(1/2), aligned 0
  add(generated, 2, {0, 2, 0, 1});  // against {0, 2, 0, 1}: 0
  const auto classes = quality_by_class(generated, real_set());
  EXPECT_EQ(classes[0].windows, 1);
  EXPECT_NEAR(classes[0].rmse, std::sqrt(0.5), 1e-15);
  EXPECT_EQ(classes[0].aligned_rmse, 0);
  EXPECT_EQ(classes[1].windows, 2);
  EXPECT_NEAR(classes[1].rmse, 0.5, 1e-15);
  EXPECT_NEAR(classes[1].amplitude_ratio, std::sqrt((17.0 + 5) / (5.0 + 5)), 1e-15);
}

TEST(QualityByClass, TakesTheBandwidthFromAllRealWindowsOfTheClass) {
  signal::WindowSet generated = empty_set();
  add(generated, 1, {1, 0, 0, 0});
  add(generated, 2, {0, 0, 0, 1});
  const auto classes = quality_by_class(generated, real_set());
  // One pair has distance 4; the three real windows have distance 8 from each other.
  double kernels = 0;
  for (const double m : {1, 2, 4, 8, 16}) kernels += std::exp(-4 / (8.0 / 4 * m));
  EXPECT_NEAR(classes[1].mmd, 2 * (5 - kernels), 1e-12);
}

/// Returns windows of 4096 samples, alternately at 600 and 1200 rpm: a carrier modulated at BPFO.
signal::WindowSet of_two_speeds(double faster_by) {
  signal::WindowSet set = empty_set();
  set.length = 4096;
  set.info.conditions = {
      {.name = "slow", .shaft_speed_rpm = 600, .known = true, .test = true, .healthy = true},
      {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = true, .healthy = true}};
  for (int i = 0; i < 8; ++i) {
    const double rpm = i % 2 == 0 ? 600 : 1200;
    const double line_hz =
        faster_by * bearing::impact_frequency_hz(set.info.bearing, bearing::Defect::outer, rpm);
    Stream random("window " + std::to_string(i));
    for (std::size_t t = 0; t < set.length; ++t) {
      const double time_s = static_cast<double>(t) / set.info.sample_rate_hz;
      const double modulation = std::cos(2 * std::numbers::pi * line_hz * time_s) +
                                std::cos(4 * std::numbers::pi * line_hz * time_s) +
                                std::cos(6 * std::numbers::pi * line_hz * time_s);
      set.samples.push_back(static_cast<float>(
          (1 + 0.2 * modulation) * std::cos(0.5 * std::numbers::pi * static_cast<double>(t)) +
          random.normal(0, 0.1)));
    }
    set.labels.push_back(2);
    set.condition.push_back(i % 2);
    set.shaft_speed_rpm.push_back(rpm);
  }
  return set;
}

TEST(QualityByClass, LooksForTheFaultLineAtTheSpeedOfEachWindow) {
  const signal::WindowSet real = of_two_speeds(1);
  const auto own = quality_by_class(real, real);
  EXPECT_GT(own[0].fault_line_db, 20);
  EXPECT_EQ(own[0].fault_line_difference_db, 0);
  // The mean of both speeds has neither line.
  EXPECT_LT(quality_by_class(of_two_speeds(1.25), real)[0].fault_line_db, 10);
}

TEST(QualityByClass, RefusesAClassThatOneSideLacks) {
  signal::WindowSet generated = empty_set();
  add(generated, 1, {1, 0, 0, 0});
  expect_refused(generated, real_set(), "class OR has 0 generated and 3 real windows");
  generated = real_set();
  add(generated, 0, {1, 0, 0, 0});
  expect_refused(generated, real_set(), "class Normal has 1 generated and 0 real windows");
}

TEST(QualityByClass, RefusesAnotherDatasetOrLength) {
  signal::WindowSet generated = real_set();
  generated.info.name = "other";
  expect_refused(generated, real_set(), "belong to data set other, the real ones to data set toy");
  generated = real_set();
  generated.info.classes[2].name = "B";
  expect_refused(generated, real_set(), "other classes");
  generated = empty_set();
  add(generated, 1, {1, 2});
  expect_refused(generated, real_set(), "generated windows have 2 samples, real ones 4");
  expect_refused(real_set(), empty_set(), "no real windows");
}

TEST(QualityByClass, RefusesRealWindowsThatCannotBeAReference) {
  const auto refused = [](const std::vector<std::vector<float>>& windows, const std::string& what) {
    signal::WindowSet real = empty_set();
    for (const auto& window : windows) add(real, 1, window);
    expect_refused(real, real, what);
  };
  refused({{1, 2, 3, 4}}, "class IR: there is only one real window");
  refused({{1, 2, 3, 4.1F}, {1, 2, 3, 4.1F}, {1, 2, 3, 4.1F}}, "all real windows are the same");
  refused({{0, 0, 0, 0}, {5, 5, 5, 5}}, "class IR: the real windows are constant");
}

signal::WindowSet set_of(int label, const Windows& windows) {
  signal::WindowSet set;
  set.info = cwru_like();
  for (Eigen::Index i = 0; i < windows.rows(); ++i) {
    const Eigen::RowVectorXf row = windows.row(i).cast<float>();
    add(set, label, {row.data(), row.data() + row.size()});
  }
  return set;
}

double difference_db(const signal::WindowSet& generated, const signal::WindowSet& real) {
  return quality_by_class(generated, real).front().fault_line_difference_db;
}

TEST(FaultLine, IsComparedWithRealWindowsOfTheClass) {
  const signal::WindowSet real = set_of(3, fault_windows(3, 20));
  EXPECT_EQ(difference_db(real, real), 0);
  EXPECT_GT(quality_by_class(real, real).front().fault_line_db, 6);
  const Windows white = noise(20, 1024, "white");
  EXPECT_LT(difference_db(set_of(3, white), real), -6);
  EXPECT_LT(difference_db(set_of(3, fault_windows(1, 20)), real), -6);
}

}  // namespace
}  // namespace piae::scoring
