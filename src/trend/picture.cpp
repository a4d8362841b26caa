#include "trend/picture.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "inspection/drawing.hpp"
#include "inspection/svg.hpp"
#include "trend/features.hpp"

namespace piae::trend {

namespace {

using inspection::Anchor;
using inspection::Axis;
using inspection::Panel;
using inspection::Stroke;
using inspection::Svg;
using monitor::AlarmState;

constexpr double page_width = 1080;
constexpr double left = 70;
constexpr double plot_width = 800;
constexpr double first_top = 92;
constexpr double between = 34;
constexpr double tall = 190;
constexpr double low = 90;
constexpr double legend_line = 15;
constexpr const char* healthy_colour = "#e0f2ea";
constexpr const char* alarm_colour = "#fbe3d6";
const Stroke limit_stroke{"#222222", 1, "6 4"};
const Stroke alarm_stroke{"#D55E00", 1.6};
const Stroke rms_stroke{"#222222", 2};
// Colours of Okabe and Ito, from low to high frequencies; last the peak.
const std::array<Stroke, level_features> level_strokes{
    Stroke{"#0072B2", 1.1}, Stroke{"#56B4E9", 1.1}, Stroke{"#009E73", 1.1}, Stroke{"#E69F00", 1.1},
    Stroke{"#D55E00", 1.1}, Stroke{"#CC79A7", 1.1}, Stroke{"#999999", 1.1}};
const std::array<Stroke, 3> line_strokes{Stroke{"#D55E00", 1.2}, Stroke{"#009E73", 1.2},
                                         Stroke{"#0072B2", 1.2}};

/// A curve: its name, stroke, and value at a point.
struct Curve {
  std::string name;
  Stroke stroke;
  std::function<double(const TrendPoint&)> value;
};

/// A panel's content. Points without a signal interrupt the curves unless `always`.
struct Content {
  std::string title;
  double height = tall;
  std::vector<Curve> curves = {};
  std::vector<double> limits = {};  ///< dashed lines
  double lowest = 0;
  double highest = 1;
  bool always = false;
};

/// Time axis and its unit.
struct Time {
  double unit_s = 3600;
  const char* unit = "h";
  Axis axis{0, 1, left, left + plot_width};

  [[nodiscard]] double x(double time_s) const { return axis.at(time_s / unit_s); }
};

double end_s(const Shown& shown) {
  if (!shown.points.empty()) return shown.points.back().time_s;
  return shown.healthy.empty() ? 1 : shown.healthy.back().time_s;
}

Time time_of(const Shown& shown) {
  constexpr double long_h = 72;
  constexpr double short_h = 0.1;
  const double hours = end_s(shown) / 3600;
  Time time;
  if (hours > long_h) time = {.unit_s = 86400, .unit = "days"};
  if (hours < short_h) time = {.unit_s = 1, .unit = "s"};
  time.axis.high = std::max(end_s(shown) / time.unit_s, 1e-9);
  return time;
}

double lowest_of(const std::vector<double>& limits_db, std::size_t first) {
  return *std::min_element(limits_db.begin() + static_cast<std::ptrdiff_t>(first), limits_db.end());
}

Curve curve_of(const Shown& shown, std::size_t feature, const Stroke& stroke) {
  return {fmt::format("{} (limit {:.1f})", shown.names[feature], shown.limits_db[feature]), stroke,
          [feature](const TrendPoint& point) {
            return point.rises->watched_db[static_cast<Eigen::Index>(feature)];
          }};
}

std::vector<Content> contents_of(const Shown& shown) {
  Content level{.title = "level above the healthy mean, dB", .lowest = -6, .highest = 9};
  for (std::size_t i = 0; i < level_features; ++i) {
    level.curves.push_back(curve_of(shown, i, level_strokes.at(i)));
  }
  level.curves.push_back(
      {"RMS", rms_stroke, [](const TrendPoint& point) { return point.rises->level_db; }});
  level.limits = {lowest_of(shown.limits_db, 0)};
  std::vector<Content> contents{level};
  if (shown.names.size() > level_features) {
    Content lines{.title = "fault lines above the healthy mean, dB", .lowest = -3, .highest = 9};
    for (std::size_t i = level_features; i < shown.names.size(); ++i) {
      lines.curves.push_back(curve_of(shown, i, line_strokes.at(i - level_features)));
    }
    lines.limits = {lowest_of(shown.limits_db, level_features)};
    contents.push_back(lines);
  }
  contents.push_back({.title = "novelty of the spectrum's shape; above 1 new (raises no alarm)",
                      .height = low,
                      .curves = {{"novelty",
                                  {"#0072B2", 1.2},
                                  [](const TrendPoint& point) { return point.rises->novelty; }}},
                      .limits = {1},
                      .highest = 1.2});
  contents.push_back({.title = "evidence: raised at 1, cleared at 0",
                      .height = low,
                      .curves = {{"evidence",
                                  {"#D55E00", 1.6},
                                  [](const TrendPoint& point) { return point.evidence; }}},
                      .limits = {1},
                      .highest = 1.1,
                      .always = true});
  return contents;
}

/// Widens the range of a panel to its curves.
void fit(Content& content, const Shown& shown) {
  for (const auto* const points : {&shown.healthy, &shown.points}) {
    for (const TrendPoint& point : *points) {
      if (!point.rises && !content.always) continue;
      for (const Curve& curve : content.curves) {
        content.lowest = std::min(content.lowest, curve.value(point));
        content.highest = std::max(content.highest, 1.04 * curve.value(point));
      }
    }
  }
}

void shade(Svg& svg, const Time& time, const Panel& panel, double from_s, double to_s,
           const char* colour) {
  const double from = time.x(from_s);
  svg.area({from, panel.top}, time.x(to_s) - from, panel.height, colour);
}

/// Shades the healthy hours and the alarms.
void draw_times(Svg& svg, const Shown& shown, const Time& time, const Panel& panel) {
  if (!shown.healthy.empty()) {
    shade(svg, time, panel, 0, shown.healthy.back().time_s, healthy_colour);
  }
  std::optional<double> raised_s;
  for (const TrendPoint& point : shown.points) {
    if (point.alarm == AlarmState::raised && !raised_s) raised_s = point.time_s;
    if (point.alarm != AlarmState::cleared || !raised_s) continue;
    shade(svg, time, panel, *raised_s, point.time_s, alarm_colour);
    raised_s.reset();
  }
  if (raised_s) shade(svg, time, panel, *raised_s, end_s(shown), alarm_colour);
}

void draw_axes(Svg& svg, const Time& time, const Panel& panel, const Axis& y, bool with_times) {
  const double step = inspection::tick_step(y.high - y.low);
  const auto last = static_cast<int>(std::floor(y.high / step));
  for (int i = static_cast<int>(std::ceil(y.low / step)); i <= last; ++i) {
    const double tick = i * step;
    svg.line({panel.left, y.at(tick)}, {panel.left + panel.width, y.at(tick)},
             inspection::grid_stroke);
    svg.text({panel.left - 6, y.at(tick) + 4}, fmt::format("{:g}", tick), Anchor::end);
  }
  const double time_step = inspection::tick_step(time.axis.high);
  for (int i = 0; i * time_step <= time.axis.high; ++i) {
    const double x = time.axis.at(i * time_step);
    svg.line({x, panel.top + panel.height}, {x, panel.top + panel.height + 4}, {"#999999", 1});
    if (!with_times) continue;
    svg.text({x, panel.top + panel.height + 17}, fmt::format("{:g}", i * time_step),
             Anchor::middle);
  }
  if (with_times)
    svg.text({panel.left + panel.width + 8, panel.top + panel.height + 17}, time.unit);
}

void draw_curve(Svg& svg, const Shown& shown, const Time& time, const Axis& y,
                const Content& content, const Curve& curve) {
  std::vector<inspection::Point> joined;
  const auto draw = [&] {
    if (joined.size() > 1) svg.polyline(joined, curve.stroke);
    joined.clear();
  };
  for (const auto* const points : {&shown.healthy, &shown.points}) {
    for (const TrendPoint& point : *points) {
      if (!point.rises && !content.always) {
        draw();
        continue;
      }
      joined.push_back({time.x(point.time_s), y.at(curve.value(point))});
    }
  }
  draw();
}

void draw_legend(Svg& svg, const Panel& panel, const Content& content) {
  double y = panel.top + 12;
  const double x = panel.left + panel.width + 14;
  for (const Curve& curve : content.curves) {
    svg.line({x, y - 4}, {x + 18, y - 4}, {curve.stroke.colour, 2.4});
    svg.text({x + 24, y}, curve.name);
    y += legend_line;
  }
}

void draw_panel(Svg& svg, const Shown& shown, const Time& time, const Panel& panel,
                const Content& content, bool is_last) {
  const Axis y{content.lowest, content.highest, panel.top + panel.height, panel.top};
  draw_times(svg, shown, time, panel);
  draw_axes(svg, time, panel, y, is_last);
  for (const Curve& curve : content.curves) draw_curve(svg, shown, time, y, content, curve);
  for (const double limit : content.limits) {
    svg.line({panel.left, y.at(limit)}, {panel.left + panel.width, y.at(limit)}, limit_stroke);
  }
  for (const TrendPoint& point : shown.points) {
    if (point.alarm != AlarmState::raised) continue;
    svg.line({time.x(point.time_s), panel.top}, {time.x(point.time_s), panel.top + panel.height},
             alarm_stroke);
  }
  svg.frame({panel.left, panel.top}, panel.width, panel.height);
  svg.text({panel.left, panel.top - 8}, content.title, Anchor::start, 12, true);
  draw_legend(svg, panel, content);
}

std::string title_of(const Shown& shown, const Time& time) {
  const auto raised = std::ranges::find(shown.points, AlarmState::raised, &TrendPoint::alarm);
  if (raised == shown.points.end()) return shown.machine + ": no alarm";
  const auto alarms = std::ranges::count(shown.points, AlarmState::raised, &TrendPoint::alarm);
  return fmt::format("{}: {}alarm at {:.2f} {}, {:.2f} {} before the end; cause: {}", shown.machine,
                     alarms > 1 ? "first " : "", raised->time_s / time.unit_s, time.unit,
                     (end_s(shown) - raised->time_s) / time.unit_s, time.unit, raised->cause);
}

}  // namespace

std::string picture_of(const Shown& shown) {
  const Time time = time_of(shown);
  std::vector<Content> contents = contents_of(shown);
  double height = first_top;
  for (const Content& content : contents) height += content.height + between;
  Svg svg(page_width, height, "trend of a machine");
  svg.text({left, 28}, title_of(shown, time), Anchor::start, 16, true);
  svg.text({left, 50}, "green: healthy hours; orange: alarm; dashed: the lowest limit");
  double top = first_top;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    fit(contents[i], shown);
    draw_panel(svg, shown, time,
               {.left = left, .top = top, .width = plot_width, .height = contents[i].height},
               contents[i], i + 1 == contents.size());
    top += contents[i].height + between;
  }
  return svg.str();
}

}  // namespace piae::trend
