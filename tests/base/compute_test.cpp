#include "base/compute.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace piae {
namespace {

TEST(Compute, IsNativeWhereItCanBeUnlessLibtorchIsAskedFor) {
  EXPECT_FALSE(needs_libtorch({Backend::automatic, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::automatic, Device::cuda}));
  EXPECT_TRUE(needs_libtorch({Backend::automatic, Device::cpu}, /*has_native=*/false));
  EXPECT_FALSE(needs_libtorch({Backend::native, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::libtorch, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::libtorch, Device::cuda}));
}

TEST(Compute, ThatCannotBeIsAnErrorThatSaysWhatCan) {
  const auto expect_usage_error = [](const std::string& part, const Compute& compute,
                                     bool has_native) {
    try {
      needs_libtorch(compute, has_native);
      FAIL() << "no error with " << part;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit(), Exit::usage);
      EXPECT_THAT(error.what(), testing::HasSubstr(part));
    }
  };
  expect_usage_error("not on cuda; use libtorch", {Backend::native, Device::cuda}, true);
  expect_usage_error("no native back end; use libtorch", {Backend::native, Device::cpu}, false);
}

int twice(int x) { return 2 * x; }
int thrice(int x) { return 3 * x; }

TEST(Backends, GiveWhatIsAskedFor) {
  constexpr Backends<int (*)(int)> both{twice, thrice};
  EXPECT_EQ(both.chosen({})(5), 10);
  EXPECT_EQ(both.chosen({Backend::libtorch, Device::cpu})(5), 15);
  constexpr Backends<int (*)(int)> libtorch_alone{nullptr, thrice};
  EXPECT_TRUE(libtorch_alone.needs_libtorch({}));
  EXPECT_EQ(libtorch_alone.chosen({})(5), 15);
}

}  // namespace
}  // namespace piae
