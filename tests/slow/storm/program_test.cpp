#include "storm/program.hpp"

#include <gtest/gtest.h>

namespace piae::storm {
namespace {

Outcome ended_with(int status, double peak_mb) {
  Outcome outcome;
  outcome.status = status;
  outcome.peak_mb = peak_mb;
  return outcome;
}

TEST(Memory, IsLimitedTo1GbUnlessAGoodModelMakesWindows) {
  const char* model = "wgan-gp.model.h5";
  EXPECT_FALSE(took_too_much(ended_with(65, 1000), model));
  EXPECT_TRUE(took_too_much(ended_with(65, 1100), model));
  EXPECT_FALSE(took_too_much(ended_with(0, 1600), model));
  EXPECT_TRUE(took_too_much(ended_with(0, 2100), model));
  EXPECT_TRUE(took_too_much(ended_with(0, 1100), "windows.h5"));
}

}  // namespace
}  // namespace piae::storm
