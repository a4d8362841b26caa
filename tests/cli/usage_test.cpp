#include "cli/usage.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <regex>
#include <vector>

namespace piae::cli {
namespace {

/// Returns seconds and megabytes.
std::pair<double, double> used_now() {
  const std::string line = usage_line();
  std::smatch numbers;
  const std::regex form(
      "step: used ([0-9]+\\.[0-9]{2}) s of processor time and ([0-9]+) MB of memory");
  EXPECT_TRUE(std::regex_match(line, numbers, form)) << line;
  return {std::stod(numbers[1]), std::stod(numbers[2])};
}

TEST(Usage, MeasuresThePeakMemory) {
  const double before_mb = used_now().second;
  constexpr std::size_t bytes = 64'000'000;
  EXPECT_EQ(std::vector<char>(bytes, 1).back(), 1);
  EXPECT_GE(used_now().second, std::min(before_mb + 1, 64.0));
  EXPECT_GE(used_now().second, 64);
}

void compute_for_200_ms() {
  const std::clock_t end = std::clock() + CLOCKS_PER_SEC / 5;
  while (std::clock() < end) continue;
}

TEST(Usage, MeasuresProcessorTime) {
  const double before_s = used_now().first;
  compute_for_200_ms();
  EXPECT_GE(used_now().first, before_s + 0.15);
}

TEST(Usage, IncludesChildProcesses) {
  const double before_s = used_now().first;
  const pid_t child = ::fork();
  if (child == 0) {
    compute_for_200_ms();
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_GE(used_now().first, before_s + 0.15);
}

}  // namespace
}  // namespace piae::cli
