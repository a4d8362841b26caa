#include "readings/reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace piae::readings {
namespace {

ReadingsOptions options_of(const std::string& readings) {
  return {.dataset = "cwru",
          .base = {"batches=mixed space=all"},
          .readings = {readings},
          .ratios = {"10to1 1to1"},
          .seeds = {"100 101"}};
}

TEST(Readings, StartWithTheBaseAndHaveSeparateFolders) {
  const Readings readings = resolve(options_of("batches=class batches=class+space=class"));
  ASSERT_EQ(readings.readings.size(), 3U);
  EXPECT_EQ(readings.readings[0].folder(), "readings/base");
  EXPECT_EQ(readings.readings[1].folder(), "readings/batches-class");
  EXPECT_EQ(readings.readings[2].folder(), "readings/batches-class+space-class");
  EXPECT_THAT(readings.base, testing::ElementsAre("batches=mixed", "space=all"));
  EXPECT_THAT(readings.grid.seeds, testing::ElementsAre(100, 101));
}

TEST(Readings, RefuseMalformedNames) {
  for (const std::string word : {"base", "batches", "batches=", "=class", "batches=class+", "+a=b",
                                 "a=b+c", "a=../b", "a=b/c"}) {
    EXPECT_ERROR(resolve(options_of(word)), Exit::usage, "'" + word + "' is not SETTING=VALUE");
  }
  EXPECT_ERROR(resolve(options_of("batches=class batches=class")), Exit::usage, "twice");
}

}  // namespace
}  // namespace piae::readings
