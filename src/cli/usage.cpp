#include "cli/usage.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>

namespace piae::cli {

namespace {

double usage_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::string usage_line() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  constexpr double mb_per_kib = 1024 / 1e6;
  return fmt::format("step: used {:.2f} s of processor time and {:.0f} MB of memory",
                     usage_seconds(used.ru_utime) + usage_seconds(used.ru_stime),
                     mb_per_kib * static_cast<double>(used.ru_maxrss));
}

}  // namespace piae::cli
