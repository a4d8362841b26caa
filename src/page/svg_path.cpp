#include "page/svg_path.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace piae::page {

namespace {

constexpr std::string_view between_numbers = " ,\t\r\n";

void skip_between(std::string_view& left) {
  left.remove_prefix(std::min(left.find_first_not_of(between_numbers), left.size()));
}

std::optional<double> take_number(std::string_view& left) {
  skip_between(left);
  double number = 0;
  const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
  if (error != std::errc()) return std::nullopt;
  left.remove_prefix(static_cast<std::size_t>(end - left.data()));
  return number;
}

/// Follows the commands of a path with a pen.
class PathParser {
 public:
  explicit PathParser(std::string_view path) : left_(path) {}

  bool run() {
    for (skip_between(left_); !left_.empty(); skip_between(left_)) {
      const char next = left_.front();
      if (std::string_view("MmLlZz").find(next) != std::string_view::npos) {
        command_ = next;
        left_.remove_prefix(1);
        if (command_ == 'Z' || command_ == 'z') close();
      } else if (!point()) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] std::vector<Polyline>& lines() { return lines_; }

 private:
  /// A pair of numbers. After a move, further pairs are lines.
  bool point() {
    const bool relative = command_ == 'm' || command_ == 'l';
    const bool moves = command_ == 'M' || command_ == 'm';
    const std::optional<double> x = take_number(left_);
    const std::optional<double> y = x ? take_number(left_) : std::nullopt;
    if (!y || command_ == 'z' || command_ == 'Z' || command_ == 0) return false;
    if (!moves && lines_.empty()) return false;
    x_ = relative ? x_ + *x : *x;
    y_ = relative ? y_ + *y : *y;
    // After a closing, a line begins where the closed one began.
    const bool begins = moves || lines_.back().closed;
    if (begins && !moves) lines_.push_back({.points = {lines_.back().points.front()}});
    if (moves) lines_.emplace_back();
    lines_.back().points.push_back({std::llround(10 * x_), std::llround(10 * y_)});
    if (moves) {
      from_x_ = x_;
      from_y_ = y_;
      command_ = relative ? 'l' : 'L';
    }
    return true;
  }
  void close() {
    if (lines_.empty()) return;
    lines_.back().closed = true;
    x_ = from_x_;
    y_ = from_y_;
  }

  std::string_view left_;
  char command_ = 0;
  double x_ = 0;
  double y_ = 0;
  double from_x_ = 0;
  double from_y_ = 0;
  std::vector<Polyline> lines_;
};

/// The distance of a point to the line from one point to another, which ends there.
double distance_to_line(const TenthsPoint& point, const TenthsPoint& from, const TenthsPoint& to) {
  const auto dx = static_cast<double>(to.x - from.x);
  const auto dy = static_cast<double>(to.y - from.y);
  const auto px = static_cast<double>(point.x - from.x);
  const auto py = static_cast<double>(point.y - from.y);
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(px - along * dx, py - along * dy);
}

std::string tenths_text(std::int64_t tenths) {
  const std::int64_t size = std::abs(tenths);
  std::string text = tenths < 0 ? "-" : "";
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += "." + std::to_string(size % 10);
  return text;
}

/// Adds a number to others, with a space where a sign does not part them.
void add_tenths(std::string& text, std::int64_t tenths) {
  const std::string number = tenths_text(tenths);
  const bool after_number = !text.empty() && text.back() >= '0' && text.back() <= '9';
  if (after_number && number.front() != '-') text += ' ';
  text += number;
}

void add_point(std::string& text, const TenthsPoint& point, TenthsPoint& last) {
  add_tenths(text, point.x - last.x);
  add_tenths(text, point.y - last.y);
  last = point;
}

}  // namespace

std::optional<std::vector<Polyline>> parse_path(const std::string& path) {
  PathParser parser(path);
  if (!parser.run()) return std::nullopt;
  return std::move(parser.lines());
}

Polyline simplified(const Polyline& line) {
  constexpr double unseen = 1;  // a tenth
  const std::vector<TenthsPoint>& points = line.points;
  if (points.size() < 3) return line;
  Polyline kept{.points = {points.front()}, .closed = line.closed};
  std::size_t last_kept = 0;
  for (std::size_t end = 2; end < points.size(); ++end) {
    const bool straight = std::all_of(
        points.begin() + static_cast<std::ptrdiff_t>(last_kept) + 1,
        points.begin() + static_cast<std::ptrdiff_t>(end), [&](const TenthsPoint& point) {
          return distance_to_line(point, points[last_kept], points[end]) <= unseen;
        });
    if (straight) continue;
    last_kept = end - 1;
    kept.points.push_back(points[last_kept]);
  }
  kept.points.push_back(points.back());
  return kept;
}

std::string path_text(const std::vector<Polyline>& lines) {
  std::string text;
  TenthsPoint last;
  for (const Polyline& line : lines) {
    const bool first = text.empty();
    text += first ? 'M' : 'm';
    add_point(text, line.points.front(), last);
    // What follows a relative move needs no letter to be a relative line.
    if (first && line.points.size() > 1) text += 'l';
    for (std::size_t i = 1; i < line.points.size(); ++i) add_point(text, line.points[i], last);
    if (!line.closed) continue;
    text += 'z';
    last = line.points.front();
  }
  return text;
}

std::string short_numbers(const std::string& numbers) {
  std::string text;
  std::string_view left = numbers;
  for (auto number = take_number(left); number; number = take_number(left)) {
    add_tenths(text, std::llround(10 * *number));
  }
  return left.empty() ? text : numbers;
}

}  // namespace piae::page
