#include "machines/lessons.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

namespace piae::machines {
namespace {

constexpr LessonOptions few{.machines = 3, .reference = 8, .healthy = 2, .of_each_fault = 2};

TEST(Lessons, HaveTheStatedNumberOfEachLabel) {
  const Lessons lessons = draw_lessons(few, Stream("lessons"));
  ASSERT_EQ(lessons.labels.size(), 3U * (2 + 3 * 2));
  for (const Label label : {0, 1, 2, 3}) {
    EXPECT_EQ(std::ranges::count(lessons.labels, label), 6) << label;
  }
}

TEST(Lessons, DoNotDependOnThreadsNorOnTheNumberOfMachines) {
  const Lessons all = draw_lessons(few, Stream("lessons"));
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  LessonOptions one = few;
  one.machines = 1;
  std::size_t done = 0;
  const Lessons first = draw_lessons(one, Stream("lessons"), [&](std::size_t n) { done = n; });
  omp_set_num_threads(threads);
  EXPECT_EQ(done, 1U);
  ASSERT_EQ(first.symptoms.size(), 8U);
  for (std::size_t i = 0; i < first.symptoms.size(); ++i) {
    EXPECT_EQ(first.symptoms[i], all.symptoms[i]) << i;
  }
}

// Rows of symptoms: 12 heights, kurtosis, three rises, ln of the novelty.
TEST(Lessons, ShowFaultsAsNewAndHealthyWindowsMostlyNot) {
  LessonOptions options = few;
  options.machines = 12;
  const Lessons lessons = draw_lessons(options, Stream("lessons"));
  double of_healthy = 0;
  double of_faulty = 0;
  for (std::size_t i = 0; i < lessons.labels.size(); ++i) {
    (lessons.labels[i] == 0 ? of_healthy : of_faulty) += lessons.symptoms[i].back();
  }
  EXPECT_LT(of_healthy / 24, 0.3);
  EXPECT_GT(of_faulty / 72, 0.8);
}

}  // namespace
}  // namespace piae::machines
