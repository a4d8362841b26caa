// Courses solved at the same time: compared with the reference, and with each course solved alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/random.hpp"
#include "bearing/dynamics.hpp"
#include "bearing/variation.hpp"
#include "support/reference_dynamics.hpp"

namespace piae::bearing {
namespace {

constexpr Sampling sampling{12000, 1200};

/// Returns courses that differ in everything in which courses may differ.
std::vector<Course> varied_courses(std::size_t count, Defect fault_type) {
  const Variation wide{
      .stiffness_spread = 0.2, .damping_spread = 0.3, .speed_spread = 0.2, .slip_max = 0.05};
  Stream stream("courses");
  std::vector<Course> courses;
  for (std::size_t i = 0; i < count; ++i) {
    DynamicsOptions options = draw_dynamics(stream, {}, wide);
    options.mass_kg = stream.uniform(0.5, 2);
    options.clearance_um = i % 3 == 0 ? 0 : stream.uniform(0.5, 5);
    options.load_n = stream.uniform(1000, 2000);
    Motion motion = draw_motion(stream, fault_type, 1797, wide);
    if (fault_type == Defect::outer && i % 2 == 1) motion.defect_angle_rad = stream.uniform(-1, 1);
    courses.push_back({motion, options});
  }
  return courses;
}

std::vector<double> row(const std::vector<double>& rows, std::size_t i) {
  const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(i * sampling.samples);
  return {begin, begin + static_cast<std::ptrdiff_t>(sampling.samples)};
}

/// Expects agreement within 1e-9 of the RMS plus the rounding of the forces: a healthy bearing's
/// vibration is only a hundred thousandth of load over mass.
void expect_reference(const std::vector<double>& x, const Geometry& geometry,
                      const LocalDefect& defect, const Course& course) {
  const DynamicsOptions& options = course.options;
  const std::vector<double> truth =
      reference::simulate(geometry, defect, course.motion, options, sampling);
  ASSERT_EQ(x.size(), truth.size());
  double largest = 0;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    largest = std::max(largest, std::abs(x[i] - truth[i]));
    squares += truth[i] * truth[i];
  }
  const double rms = std::sqrt(squares / static_cast<double>(x.size()));
  EXPECT_LT(largest, 1e-9 * rms + 1e-13 * options.load_n / options.mass_kg)
      << geometry.balls << " balls, defect of " << defect.size_mm << " mm, clearance "
      << options.clearance_um << " um";
}

class Courses : public testing::TestWithParam<Defect> {
 protected:
  [[nodiscard]] LocalDefect defect(double size_mm) const {
    return {GetParam(), GetParam() == Defect::none ? 0 : size_mm};
  }
};

TEST_P(Courses, MatchTheReference) {
  const std::vector<Course> courses = varied_courses(2 * courses_at_once + 3, GetParam());
  for (const double size_mm : {0.1778, 0.5334}) {
    const std::vector<double> rows = simulate({}, defect(size_mm), courses, sampling);
    ASSERT_EQ(rows.size(), courses.size() * sampling.samples);
    for (std::size_t i = 0; i < courses.size(); ++i) {
      expect_reference(row(rows, i), {}, defect(size_mm), courses[i]);
    }
  }
}

TEST_P(Courses, MatchTheReferenceInOtherBearings) {
  const std::vector<Course> courses = varied_courses(3, GetParam());
  for (const int balls : {3, 4, 7, 8, 16}) {
    Geometry geometry;
    geometry.balls = balls;
    geometry.ball_diameter_mm = 5;
    geometry.contact_angle_deg = 15;
    const std::vector<double> rows = simulate(geometry, defect(0.3), courses, sampling);
    for (std::size_t i = 0; i < courses.size(); ++i) {
      expect_reference(row(rows, i), geometry, defect(0.3), courses[i]);
    }
  }
}

TEST_P(Courses, DoNotDependOnTheirNeighbours) {
  const std::vector<Course> courses = varied_courses(2 * courses_at_once + 3, GetParam());
  const std::vector<double> rows = simulate({}, defect(0.1778), courses, sampling);
  const std::vector<double> shifted =
      simulate({}, defect(0.1778), std::span(courses).subspan(1), sampling);
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const auto& [motion, options] = courses[i];
    EXPECT_EQ(row(rows, i), simulate({}, defect(0.1778), motion, options, sampling));
    if (i > 0) {
      EXPECT_EQ(row(rows, i), row(shifted, i - 1));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Courses,
                         testing::Values(Defect::none, Defect::outer, Defect::inner,
                                         Defect::roller));

/// A ball at -90 or 90 degrees carries nothing, however its cosine is rounded.
TEST(Courses, MayStartAtTheEntryOfABall) {
  constexpr double right_angle = std::numbers::pi / 2;
  for (const double cage : {-right_angle, right_angle, 3 * right_angle, -5 * right_angle}) {
    for (const double clearance_um : {0.0, 2.0}) {
      const Course course{{.shaft_speed_rpm = 1797, .cage_angle_rad = cage},
                          {.clearance_um = clearance_um, .settling_s = 0}};
      const LocalDefect defect{Defect::outer, 0.1778};
      expect_reference(simulate({}, defect, course.motion, course.options, sampling), {}, defect,
                       course);
    }
  }
}

std::string message_of(const std::vector<Course>& courses, Exit exit) {
  try {
    simulate({}, {Defect::outer, 0.1778}, courses, sampling);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), exit);
    return error.what();
  }
  return "no error";
}

TEST(Courses, ReportDivergenceInAnyPlace) {
  const std::vector<Course> calm = varied_courses(courses_at_once + 2, Defect::outer);
  for (std::size_t i = 0; i < calm.size(); ++i) {
    std::vector<Course> courses = calm;
    courses[i].options.damping_ns_per_m = 1e7;
    EXPECT_THAT(message_of(courses, Exit::failed), testing::HasSubstr("diverged at"));
  }
  EXPECT_EQ(message_of(calm, Exit::failed), "no error");
}

/// 30 ms of settling are 360 samples; the course diverges in the first of them.
TEST(Courses, ReportTheTimeAndSubStepOfDivergence) {
  std::vector<Course> courses = varied_courses(2, Defect::outer);
  courses[1].options.damping_ns_per_m = 1e9;
  EXPECT_EQ(message_of(courses, Exit::failed),
            "eq. 13 diverged at -0.0299167 s with sub-steps of 1.98e-06 s; stiffness and damping "
            "over mass require shorter ones");
}

TEST(Courses, RefuseImpossibleValuesInAnyPlace) {
  std::vector<Course> courses = varied_courses(3, Defect::outer);
  courses[2].options.mass_kg = 0;
  EXPECT_THAT(message_of(courses, Exit::bad_input), testing::HasSubstr("mass in kg 0"));
  courses = varied_courses(3, Defect::outer);
  courses[2].motion.slip = 1;
  EXPECT_THAT(message_of(courses, Exit::bad_input), testing::HasSubstr("slip 1"));
}

TEST(Courses, RefuseDifferentTimeGrids) {
  std::vector<Course> courses = varied_courses(2, Defect::outer);
  courses[1].options.settling_s = 0.01;
  EXPECT_THAT(message_of(courses, Exit::bad_input), testing::HasSubstr("differ in settling time"));
  courses[1].options = courses[0].options;
  courses[1].options.max_sub_step_s = 1e-6;
  EXPECT_THAT(message_of(courses, Exit::bad_input), testing::HasSubstr("longest sub-step"));
}

TEST(Courses, GiveNoSignalWithoutABearing) {
  EXPECT_TRUE(simulate({}, {}, std::span<const Course>(), sampling).empty());
}

}  // namespace
}  // namespace piae::bearing
