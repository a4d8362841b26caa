#include "cli/usage.hpp"

#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>

#include <algorithm>

namespace piae::cli {

namespace {

double usage_seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double processor_seconds(const rusage& used) {
  return usage_seconds(used.ru_utime) + usage_seconds(used.ru_stime);
}

rusage usage_of(__rusage_who who) {
  rusage used{};
  ::getrusage(who, &used);
  return used;
}

}  // namespace

std::string usage_line() {
  const rusage own = usage_of(RUSAGE_SELF);
  const rusage helpers = usage_of(RUSAGE_CHILDREN);
  constexpr double mb_per_kib = 1024 / 1e6;
  return fmt::format("step: used {:.2f} s of processor time and {:.0f} MB of memory",
                     processor_seconds(own) + processor_seconds(helpers),
                     mb_per_kib * static_cast<double>(std::max(own.ru_maxrss, helpers.ru_maxrss)));
}

}  // namespace piae::cli
