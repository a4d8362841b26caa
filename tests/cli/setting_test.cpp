#include "cli/setting.hpp"

#include <gmock/gmock.h>

namespace piae::cli {
namespace {

using testing::HasSubstr;

enum class Shape { round, flat };

/// Returns why a program with a number and a word rejects a setting.
std::string refusal(const std::string& name, const std::string& value) {
  double size = 1;
  Shape shape = Shape::round;
  const auto bind = [&](const Options& options) {
    options.add("--size", size, "how large").check(positive_number());
    options.choose<Shape>("--shape", shape, {{"round", Shape::round}, {"flat", Shape::flat}},
                          "of which shape");
  };
  return refusal_of(bind, name, value);
}

TEST(Setting, IsAnOptionWithAValidValue) {
  EXPECT_EQ(refusal("size", "2e-3"), "");
  EXPECT_EQ(refusal("shape", "flat"), "");
  EXPECT_EQ(refusal("weight", "2"), "there is no option --weight");
  EXPECT_EQ(refusal("help", "2"), "there is no option --help");
  EXPECT_THAT(refusal("size", "0"), HasSubstr("'0' is not a positive number"));
  EXPECT_THAT(refusal("size", "2+shape=flat"), HasSubstr("--size"));
  EXPECT_THAT(refusal("shape", "square"), HasSubstr("'square' is not one of: round, flat"));
}

}  // namespace
}  // namespace piae::cli
