#include "base/compute.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace piae {
namespace {

TEST(Compute, IsNativeIfPossibleUnlessLibtorchIsRequested) {
  EXPECT_FALSE(needs_libtorch({Backend::automatic, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::automatic, Device::cuda}));
  EXPECT_FALSE(needs_libtorch({Backend::native, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::libtorch, Device::cpu}));
  EXPECT_TRUE(needs_libtorch({Backend::libtorch, Device::cuda}));
}

TEST(Compute, RefusesImpossibleChoicesWithAnAlternative) {
  try {
    needs_libtorch({Backend::native, Device::cuda});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    EXPECT_THAT(error.what(), testing::HasSubstr("not on cuda; use libtorch"));
  }
}

int twice(int x) { return 2 * x; }
int thrice(int x) { return 3 * x; }

TEST(Backends, GiveTheRequestedBackend) {
  constexpr Backends<int (*)(int)> both{twice, thrice};
  EXPECT_EQ(both.chosen({})(5), 10);
  EXPECT_EQ(both.chosen({Backend::libtorch, Device::cpu})(5), 15);
  constexpr Backends<int (*)(int)> without_libtorch{twice, nullptr};
  EXPECT_EQ(without_libtorch.chosen({})(5), 10);
  try {
    (void)without_libtorch.chosen({Backend::libtorch, Device::cpu});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::failed);
    EXPECT_THAT(error.what(), testing::HasSubstr("not linked with LibTorch"));
  }
}

}  // namespace
}  // namespace piae
