#include "signal/measured_speed.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "raw/file.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t fewest_pulses = 3;
constexpr double uncovered_pulses = 2;  // at either end
constexpr double missing_pulse = 1.5;   // step over its neighbour
constexpr double least_step_s = 1e-3;   // of angles from a channel, so that they take less memory
constexpr double seconds_a_minute = 60;

[[noreturn]] void refuse_speed(const std::string& where, const std::string& what) {
  throw Error(Exit::bad_input, where + ": " + what);
}

void require_increasing(std::span<const double> times_s, const std::string& where) {
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    if (times_s[i] > times_s[i - 1]) continue;  // false for NaN
    refuse_speed(where, fmt::format("time {} of the pulses, {:.9g} s, does not follow the previous "
                                    "one, {:.9g} s; give ascending times in s",
                                    i + 1, times_s[i], times_s[i - 1]));
  }
}

void require_turning(std::span<const double> times_s, double pulses_per_turn,
                     const std::string& where) {
  double previous_s = times_s[1] - times_s[0];
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double step_s = times_s[i] - times_s[i - 1];
    const double rpm = seconds_a_minute / (pulses_per_turn * step_s);
    if (!ranges::shaft_speed_rpm.holds(rpm)) {
      refuse_speed(where,
                   fmt::format("the pulses at {:.9g} and {:.9g} s make a speed of {:g} rpm, "
                               "which {}; correct the times or pulses_per_turn",
                               times_s[i - 1], times_s[i], rpm, ranges::shaft_speed_rpm.rule()));
    }
    if (std::max(step_s, previous_s) > missing_pulse * std::min(step_s, previous_s)) {
      refuse_speed(where, fmt::format("the time from pulse to pulse changes from {:.4g} to {:.4g} "
                                      "s at {:.9g} s: a pulse is missing or double; correct it",
                                      previous_s, step_s, times_s[i - 1]));
    }
    previous_s = step_s;
  }
}

void require_covered(std::span<const double> times_s, double duration_s, const std::string& where) {
  const std::size_t n = times_s.size();
  const double first_s = times_s[0] - uncovered_pulses * (times_s[1] - times_s[0]);
  const double last_s = times_s[n - 1] + uncovered_pulses * (times_s[n - 1] - times_s[n - 2]);
  if (first_s <= 0 && last_s >= duration_s) return;
  refuse_speed(where, fmt::format("the pulses from {:.6g} to {:.6g} s do not cover the record, "
                                  "which lasts {:.6g} s; give times from its start to its end, "
                                  "counted from its start",
                                  times_s[0], times_s[n - 1], duration_s));
}

ShaftAngle angle_of_speeds(const raw::Signals& speeds, const RecordTimes& record,
                           const std::string& where) {
  ShaftAngle angle{.time_s = {0}, .turns = {0}};
  std::size_t i = 0;
  double start_s = 0;
  double turns = 0;
  for (std::size_t piece = 0; piece < speeds.pieces.size(); ++piece) {
    const std::size_t count = speeds.pieces[piece].samples;
    const double step_s = record.piece_s[piece] / static_cast<double>(count);
    for (std::size_t k = 1; k <= count; ++k, ++i) {
      const double rpm = speeds.samples[i];
      if (!ranges::shaft_speed_rpm.holds(rpm)) {
        refuse_speed(where, fmt::format("is {:g} at sample {} (counted from 0), but a shaft speed "
                                        "{}; name a channel of speeds in rpm",
                                        rpm, i, ranges::shaft_speed_rpm.rule()));
      }
      turns += rpm / seconds_a_minute * step_s;
      const double time_s = start_s + static_cast<double>(k) * step_s;
      if (k < count && time_s - angle.time_s.back() < least_step_s) continue;
      angle.turns.push_back(turns);
      angle.time_s.push_back(time_s);
    }
    start_s += record.piece_s[piece];
  }
  return angle;
}

ShaftAngle read_pulses(const SpeedSource& source, const fs::path& file, const RecordTimes& record,
                       double duration_s) {
  const std::string where = fmt::format("{} (record {})", file.string(), record.name);
  if (record.files.size() > 1) {
    refuse_speed(where, fmt::format("holds the pulses of one recording, but the record has {} "
                                    "files; describe each as a record with its own pulses",
                                    record.files.size()));
  }
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    throw Error(Exit::input_missing, where + ": no such file; correct shaft_speed_rpm.file");
  }
  return angle_of_pulses(raw::read(file, source.variable), source.pulses_per_turn, duration_s,
                         where);
}

}  // namespace

ShaftAngle angle_of_pulses(std::span<const double> times_s, double pulses_per_turn,
                           double duration_s, const std::string& where) {
  if (times_s.size() < fewest_pulses) {
    refuse_speed(where, fmt::format("holds {} pulses, but a speed over time needs {} or more",
                                    times_s.size(), fewest_pulses));
  }
  require_increasing(times_s, where);
  require_turning(times_s, pulses_per_turn, where);
  require_covered(times_s, duration_s, where);
  ShaftAngle angle{.time_s = {times_s.begin(), times_s.end()}, .turns = {}};
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    angle.turns.push_back(static_cast<double>(i) / pulses_per_turn);
  }
  return angle;
}

SpeedCourse read_speed(const SpeedSource& source, const fs::path& data_dir,
                       const RecordTimes& record) {
  const double duration_s = std::accumulate(record.piece_s.begin(), record.piece_s.end(), 0.0);
  if (!source.file.empty()) {
    return speed_course(read_pulses(source, data_dir / source.file, record, duration_s), duration_s,
                        record.sample_s);
  }
  const std::string where = fmt::format("{} (record {}): {}", record.files.front().string(),
                                        record.name, source.variable);
  return speed_course(angle_of_speeds(raw::read_all(record.files, source.variable), record, where),
                      duration_s, record.sample_s);
}

}  // namespace piae::signal
