#include "page/time_line.hpp"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <ctime>
#include <set>
#include <string>

namespace piae::page {

namespace {

// Units of the picture, which is scaled to the available width.
constexpr double picture_width = 1000;
constexpr double names_width = 90;
constexpr double gap_width = 14;
constexpr double beyond_last_tick = 60;  // room for its label
constexpr double row_height = 26;
constexpr double row_space = 6;
constexpr double axis_height = 34;
constexpr double narrowest_bar = 0.7;

constexpr double pause_s = 600;

double end_of_step(const run::StepLog& step) { return *step.started_s + step.elapsed_s; }

/// Maps moments to positions in the picture.
class Axis {
 public:
  explicit Axis(std::vector<Session> sessions) : sessions_(std::move(sessions)) {
    double total_s = 0;
    for (const Session& session : sessions_) total_s += length_of(session);
    const auto gaps = static_cast<double>(sessions_.size() - 1);
    units_per_s_ = (picture_width - names_width - beyond_last_tick - gap_width * gaps) / total_s;
  }

  [[nodiscard]] double at(double moment_s) const {
    double x = names_width;
    for (const Session& session : sessions_) {
      if (moment_s <= session.end_s) return x + (moment_s - session.begin_s) * units_per_s_;
      x += length_of(session) * units_per_s_ + gap_width;
    }
    return x;
  }
  [[nodiscard]] double units(double seconds) const { return seconds * units_per_s_; }
  [[nodiscard]] const std::vector<Session>& sessions() const { return sessions_; }

 private:
  /// Returns at least a second, so that an empty session can be drawn.
  static double length_of(const Session& session) {
    return std::max(1.0, session.end_s - session.begin_s);
  }

  std::vector<Session> sessions_;
  double units_per_s_;
};

std::string position(double number) { return fmt::format("{:.6g}", std::round(10 * number) / 10); }

/// Returns the lane of each step, counted from 0: the first free one.
std::vector<std::size_t> lanes_of(const std::vector<const run::StepLog*>& steps) {
  std::vector<double> free_at_s;
  std::vector<std::size_t> lanes;
  for (const run::StepLog* step : steps) {
    auto lane =
        std::ranges::find_if(free_at_s, [&](double end) { return end <= *step->started_s; });
    if (lane == free_at_s.end()) lane = free_at_s.insert(free_at_s.end(), 0);
    *lane = end_of_step(*step);
    lanes.push_back(static_cast<std::size_t>(lane - free_at_s.begin()));
  }
  return lanes;
}

/// Consecutive steps of a lane that are drawn as one bar.
struct Bar {
  std::size_t lane = 0;
  const run::StepLog* first = nullptr;
  double end_s = 0;
  std::size_t steps = 1;
};

/// Returns a bar for each step. Merges bars of large runs, which would mostly overlap: steps that
/// follow each other in a lane, have the same end, and together are too narrow to distinguish.
std::vector<Bar> bars_of(const std::vector<const run::StepLog*>& steps, const Axis& axis) {
  constexpr std::size_t many = 2000;
  constexpr double widest_together = 2;
  const std::vector<std::size_t> lanes = lanes_of(steps);
  std::vector<Bar> bars;
  std::vector<std::size_t> last_of_lane(std::ranges::max(lanes) + 1, steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const run::StepLog& step = *steps[i];
    std::size_t& last = last_of_lane[lanes[i]];
    const bool follows =
        steps.size() > many && last < bars.size() && bars[last].first->end == step.end &&
        step.end != run::StepEnd::open &&
        axis.at(end_of_step(step)) - axis.at(*bars[last].first->started_s) < widest_together;
    if (follows) {
      bars[last].end_s = end_of_step(step);
      ++bars[last].steps;
    } else {
      last = bars.size();
      bars.push_back({.lane = lanes[i], .first = &step, .end_s = end_of_step(step)});
    }
  }
  return bars;
}

std::string title_of_bar(const Bar& bar) {
  const run::StepLog& step = *bar.first;
  std::string title = step.file.generic_string() + ", ";
  if (bar.steps > 1) title += fmt::format("and {} more, ", bar.steps - 1);
  title += word_of(step.end);
  return step.end == run::StepEnd::open
             ? title
             : title + " after " + duration_label(bar.end_s - *step.started_s);
}

Html html_of_bar(const Bar& bar, const Axis& axis, double y, double height) {
  const run::StepLog& step = *bar.first;
  return element(
      "rect",
      {{"class", "bar " + word_of(step.end)},
       {"x", position(axis.at(*step.started_s))},
       {"y", position(y)},
       {"width", position(std::max(narrowest_bar, axis.units(bar.end_s - *step.started_s)))},
       {"height", position(height)}},
      element("title", title_of_bar(bar)));
}

Html label(double x, double y, const std::string& text, const std::string& looks) {
  return element("text", {{"x", position(x)}, {"y", position(y)}, {"class", looks}}, text);
}

Html vertical(double x, double from, double to) {
  return element("line",
                 {{"class", "tick"},
                  {"x1", position(x)},
                  {"x2", position(x)},
                  {"y1", position(from)},
                  {"y2", position(to)}},
                 Html());
}

Html row_of_stage(const std::string& stage, const std::vector<run::StepLog>& steps,
                  const Axis& axis, double y) {
  std::vector<const run::StepLog*> own;
  for (const run::StepLog& step : steps) {
    if (step.stage == stage) own.push_back(&step);
  }
  const std::vector<Bar> bars = bars_of(own, axis);
  const std::size_t lanes = std::ranges::max(bars, {}, &Bar::lane).lane + 1;
  const double height = row_height / static_cast<double>(lanes);
  Html row = label(0, y + row_height / 2 + 4, stage, "name");
  for (const Bar& bar : bars) {
    row += html_of_bar(bar, axis, y + height * static_cast<double>(bar.lane), 0.9 * height);
  }
  return row;
}

/// Returns the distance between ticks: a round number of seconds, minutes or hours, about eight
/// ticks in all.
double tick_distance_s(const Axis& axis) {
  constexpr double wanted_units = 110;
  for (const double distance :
       {1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 10800, 21600, 43200}) {
    if (axis.units(distance) >= wanted_units) return distance;
  }
  return 86400;
}

Html ticks(const Axis& axis, double bottom) {
  const double distance_s = tick_distance_s(axis);
  Html all;
  for (const Session& session : axis.sessions()) {
    const double begin = axis.at(session.begin_s);
    all += vertical(begin, 0, bottom) +
           label(begin, bottom + 28, moment_label(session.begin_s), "moment");
    for (double t = 0; session.begin_s + t <= session.end_s; t += distance_s) {
      const double x = axis.at(session.begin_s + t);
      if (t > 0) all += vertical(x, 0, bottom);
      all += label(x, bottom + 14, t == 0 ? "0" : duration_label(t), "tick");
    }
  }
  return all;
}

}  // namespace

std::string duration_label(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
  const double minutes = seconds / 60;
  return minutes < 99.5 ? fmt::format("{:.1f} min", minutes)
                        : fmt::format("{:.1f} h", minutes / 60);
}

std::string moment_label(double seconds_since_1970) {
  const auto seconds = static_cast<std::time_t>(seconds_since_1970);
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(seconds));
}

std::string word_of(run::StepEnd end) {
  switch (end) {
    case run::StepEnd::done:
      return "done";
    case run::StepEnd::interrupted:
      return "interrupted";
    case run::StepEnd::failed:
      return "failed";
    case run::StepEnd::open:
      break;
  }
  return "open";
}

std::vector<Session> sessions_of(const std::vector<run::StepLog>& steps) {
  std::vector<Session> sessions;
  for (const run::StepLog& step : steps) {
    if (sessions.empty() || *step.started_s > sessions.back().end_s + pause_s) {
      sessions.push_back({*step.started_s, *step.started_s});
    }
    sessions.back().end_s = std::max(sessions.back().end_s, end_of_step(step));
  }
  return sessions;
}

std::vector<std::string> stages_in_order(const std::vector<run::StepLog>& steps) {
  std::set<std::string> left;
  for (const run::StepLog& step : steps) left.insert(step.stage);
  std::vector<std::string> stages;
  for (const char* stage : {"ingest", "simulate", "split", "train", "generate", "score", "diagnose",
                            "tabulate", "figures"}) {
    if (left.erase(stage) > 0) stages.emplace_back(stage);
  }
  stages.insert(stages.end(), left.begin(), left.end());
  return stages;
}

Html time_line(const std::vector<run::StepLog>& steps) {
  const Axis axis(sessions_of(steps));
  const std::vector<std::string> stages = stages_in_order(steps);
  const double bottom = static_cast<double>(stages.size()) * (row_height + row_space);
  Html content = ticks(axis, bottom);
  double y = 0;
  for (const std::string& stage : stages) {
    content += row_of_stage(stage, steps, axis, y);
    y += row_height + row_space;
  }
  const std::string name =
      "Time of each step, one row for each stage; the table below has the numbers";
  const std::string box = "0 0 " + position(picture_width) + " " + position(bottom + axis_height);
  return element(
      "div", {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", name}},
      element("svg",
              {{"class", "time-line"}, {"viewBox", box}, {"role", "img"}, {"aria-label", name}},
              content));
}

}  // namespace piae::page
