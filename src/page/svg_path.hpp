#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace piae::page {

/// A point of a picture, in tenths of its unit.
struct TenthsPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  bool operator==(const TenthsPoint&) const = default;
};

/// Lines from each point to the next.
struct Polyline {
  std::vector<TenthsPoint> points;
  bool closed = false;
};

/// The lines of an SVG path. Empty where it has anything in it but moves, lines and closings,
/// absolute or relative.
std::optional<std::vector<Polyline>> parse_path(const std::string& path);

/// The same lines without points that lie within a tenth of a straight line between their
/// neighbours, so that nobody sees a difference.
Polyline simplified(const Polyline& line);

/// The path in few characters: each point from the one before.
std::string path_text(const std::vector<Polyline>& lines);

/// Numbers between spaces and commas, rounded to tenths.
std::string short_numbers(const std::string& numbers);

}  // namespace piae::page
