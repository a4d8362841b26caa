#include "trend/trend_point.hpp"

#include <spdlog/fmt/fmt.h>

#include "trend/features.hpp"

namespace piae::trend {

namespace {

std::string decibels(const std::optional<double>& db) {
  return db ? fmt::format("{:.2f}", *db) : "null";
}

/// Names of features hold nothing that JSON escapes.
std::string in_quotes(const std::string& name) {
  return name.empty() ? "null" : fmt::format("\"{}\"", name);
}

/// The feature that rose most among some of them.
struct Highest {
  std::optional<double> db;
  std::string name;
};

Highest highest(const TrendPoint& point, const std::vector<std::string>& names, std::size_t first,
                std::size_t count) {
  if (!point.rises || first + count > names.size() || count == 0) return {};
  Eigen::Index place = 0;
  const double db = point.rises->watched_db
                        .segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count))
                        .maxCoeff(&place);
  return {db, names[first + static_cast<std::size_t>(place)]};
}

}  // namespace

std::string json_line(const TrendPoint& p, const std::vector<std::string>& names) {
  const Highest level = highest(p, names, 0, level_features);
  Highest line = highest(p, names, level_features, names.size() - level_features);
  line.name = line.name.substr(0, line.name.find(' '));
  const auto of = [&](double TrendPoint::Rises::*value) {
    return p.rises ? std::optional((*p.rises).*value) : std::nullopt;
  };
  return fmt::format(
      "{{\"time_s\": {:.3f}, \"windows\": {}, \"level_db\": {}, \"rise_db\": {}, \"feature\": {}, "
      "\"line_db\": {}, \"line\": {}, \"novelty\": {}, \"evidence\": {:.4f}, \"alarm\": \"{}\", "
      "\"cause\": {}}}\n",
      p.time_s, p.windows, decibels(of(&TrendPoint::Rises::level_db)), decibels(level.db),
      in_quotes(level.name), decibels(line.db), in_quotes(line.name),
      decibels(of(&TrendPoint::Rises::novelty)), p.evidence, monitor::to_string(p.alarm),
      in_quotes(p.cause));
}

}  // namespace piae::trend
