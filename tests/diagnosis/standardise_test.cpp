#include "diagnosis/standardise.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "diagnosis/sets.hpp"

namespace piae::diagnosis {
namespace {

TEST(Standardise, ScalesEachWindowByItself) {
  signal::WindowSet set = empty_set(4);
  set.samples = {1, 3, 1, 3, 100, 100, 100, 104};
  set.labels = {0, 2};
  const LabelledWindows result = standardise(set, "--test");
  EXPECT_EQ(result.size(), 2U);
  EXPECT_EQ(result.length, 4U);
  EXPECT_EQ(result.classes, 3U);
  EXPECT_EQ(result.labels, set.labels);
  // Means 2 and 101, standard deviations 1 and sqrt(3).
  const std::vector<float> expected{-1,           1,         -1, 1, -0.57735027F, -0.57735027F,
                                    -0.57735027F, 1.7320508F};
  EXPECT_THAT(result.samples, testing::Pointwise(testing::FloatNear(1e-6F), expected));
}

TEST(Standardise, RemovesOffsetAndGain) {
  signal::WindowSet set = empty_set(4);
  set.samples = {1, 2, 4, 3, 1e4F + 1, 1e4F + 2, 1e4F + 4, 1e4F + 3, 1e-6F, 2e-6F, 4e-6F, 3e-6F};
  set.labels = {0, 1, 2};
  const std::vector<float> out = standardise(set, "--test").samples;
  for (std::size_t t = 0; t < 4; ++t) {
    EXPECT_NEAR(out[t], out[4 + t], 1e-6);
    EXPECT_NEAR(out[t], out[8 + t], 1e-6);
  }
}

TEST(Standardise, NamesAConstantWindow) {
  signal::WindowSet set = empty_set(4);
  set.samples = {1, 2, 3, 4, 0.1F, 0.1F, 0.1F, 0.1F};
  set.labels = {0, 1};
  try {
    standardise(set, "--known");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::bad_input);
    EXPECT_THAT(error.what(), testing::StartsWith("--known: window 1 (class IR) is constant"));
  }
}

}  // namespace
}  // namespace piae::diagnosis
