#include "raw/limits.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <new>
#include <vector>

#include "support/child_process.hpp"

namespace piae::raw {
namespace {

constexpr Limits tight{.memory_bytes = 32'000'000, .processor_seconds = 1};

/// Returns 1 if this memory is refused.
int status_with(std::size_t bytes) {
  return status_of_child([&] {
    keep_to(tight);
    try {
      std::vector<char> memory(bytes);
      static volatile char last = memory.back();
      (void)last;
    } catch (const std::bad_alloc&) {
      ::_exit(1);
    }
  });
}

TEST(LimitsOfAProcess, RefuseMemoryBeyondThem) {
  EXPECT_EQ(status_with(16'000'000), 0);
  EXPECT_EQ(status_with(64'000'000), 1);
}

TEST(LimitsOfAProcess, EndItAfterItsProcessorTime) {
  EXPECT_EQ(status_of_child([] {
              keep_to(tight);
              for (volatile bool forever = true; forever;) {
              }
            }),
            128 + SIGXCPU);
}

}  // namespace
}  // namespace piae::raw
