#include "monitor/decision.hpp"

#include <spdlog/fmt/fmt.h>

namespace piae::monitor {

namespace {

/// Returns the name in quotes, or null. Class names hold nothing that JSON escapes
/// (signal::ranges).
std::string quoted(const std::string& name) {
  return name.empty() ? "null" : fmt::format("\"{}\"", name);
}

}  // namespace

std::string json_line(const Decision& d, const signal::DatasetInfo& info) {
  return fmt::format(
      "{{\"time_s\": {:.3f}, \"windows\": {}, \"class\": {}, \"probability\": {:.4f}, "
      "\"unknown\": {}, \"evidence\": {:.4f}, \"alarm\": \"{}\", \"cause\": {}}}\n",
      d.time_s, d.windows, quoted(d.label ? info.class_of(*d.label).name : ""), d.probability,
      d.unknown, d.evidence, to_string(d.alarm), quoted(d.cause));
}

}  // namespace piae::monitor
