#include "raw/times.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "raw/csv_fields.hpp"

namespace piae::raw {

namespace {

constexpr double regular_share = 0.9;
constexpr double regular_within = 0.25;  // share of the median step, on either side
constexpr double steps_of_a_gap = 1.5;
constexpr std::size_t fewest_times = 20;
constexpr std::size_t most_steps_back = 10;  // for a column whose name is not a time
constexpr double fewest_coarse_steps = 200;  // rounding then moves their mean by 0.5 % at most

struct Unit {
  std::string_view name;
  double s;
};
constexpr std::array units{Unit{"s", 1},
                           Unit{"sec", 1},
                           Unit{"secs", 1},
                           Unit{"second", 1},
                           Unit{"seconds", 1},
                           Unit{"sek", 1},
                           Unit{"ms", 1e-3},
                           Unit{"msec", 1e-3},
                           Unit{"millis", 1e-3},
                           Unit{"milliseconds", 1e-3},
                           Unit{"us", 1e-6},
                           Unit{"\xC2\xB5s", 1e-6},  // micro sign
                           Unit{"\xCE\xBCs", 1e-6},  // Greek mu
                           Unit{"usec", 1e-6},
                           Unit{"micros", 1e-6},
                           Unit{"microseconds", 1e-6},
                           Unit{"ns", 1e-9},
                           Unit{"nanoseconds", 1e-9}};

double unit_called(std::string_view name) {
  const auto* const unit = std::ranges::find(units, name, &Unit::name);
  return unit == units.end() ? 0 : unit->s;
}

/// True for "time", "time 1", "time_s", but not for "timer".
bool begins_as_time(std::string_view name) {
  constexpr std::array words{"time",    "zeit",    "temps", "tiempo", "tempo",  "timestamp",
                             "elapsed", "seconds", "sec",   "millis", "micros", "t"};
  return std::ranges::any_of(words, [&](std::string_view word) {
    if (!name.starts_with(word)) return false;
    const std::string_view rest = name.substr(word.size());
    return rest.empty() || std::isalpha(static_cast<unsigned char>(rest.front())) == 0;
  });
}

/// Returns the unit in brackets at the end of a name.
std::string_view unit_in_brackets(std::string_view name) {
  for (const std::string_view pair : {"()", "[]", "<>"}) {
    const std::size_t open = name.rfind(pair[0]);
    if (open == std::string_view::npos || name.back() != pair[1]) continue;
    return trimmed(name.substr(open + 1, name.size() - open - 2), blanks);
  }
  return {};
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Returns the mean of the usual steps, because the median alone has the rounding of the printed
/// times. Returns 0 if the steps are uneven.
double usual_step(const std::vector<double>& steps) {
  const double median = median_of(steps);
  if (!(median > 0)) return 0;
  double sum = 0;
  double regular = 0;
  for (const double step : steps) {
    if (std::abs(step - median) > regular_within * median) continue;
    sum += step;
    ++regular;
  }
  return regular < regular_share * static_cast<double>(steps.size()) ? 0 : sum / regular;
}

void look_for_gaps(const std::vector<double>& steps, Times& times) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i] <= steps_of_a_gap * times.step) continue;
    const auto missing = static_cast<std::size_t>(std::round(steps[i] / times.step)) - 1;
    ++times.gaps;
    times.missing += missing;
    if (missing <= times.longest) continue;
    times.longest = missing;
    times.longest_after = i;
  }
}

/// True if the steps have more values than rounding of even steps can give.
bool are_scattered(const std::vector<double>& steps, double mean) {
  constexpr std::size_t many = 20;
  constexpr double parts = 50;  // parts per mean step
  std::set<std::int64_t> values;
  for (const double step : steps) {
    const double part = step / mean * parts;
    if (part >= 0 && part < 10 * parts) values.insert(static_cast<std::int64_t>(part));
    if (values.size() > many) return true;
  }
  return false;
}

constexpr std::array likely_units_s{1., 1e-3, 1e-6, 1e-9, 86400.};

bool agree(double step, double unit_s, double rate_hz, double within = 0.01) {
  return step > 0 && std::abs(step * unit_s * rate_hz - 1) <= within;
}

}  // namespace

TimeName time_name(std::string_view name) {
  name = trimmed(name, blanks);
  std::string lower(name);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string_view text = lower;
  const bool is_time = name != "T" && !name.starts_with("T ") && begins_as_time(text);
  if (text.empty()) return {};
  double unit_s = unit_called(unit_in_brackets(text));
  if (unit_s > 0) return {true, unit_s};
  unit_s = unit_called(text);
  const std::size_t last = text.find_last_of("/_ ,:");
  if (is_time && last != std::string_view::npos) unit_s = unit_called(text.substr(last + 1));
  return {is_time, unit_s};
}

std::string_view unit_name(double unit_s) {
  constexpr std::array names{"s", "ms", "us", "ns"};
  return names.at(static_cast<std::size_t>(std::lround(-std::log10(unit_s) / 3)));
}

Times times_in(std::span<const double> numbers, Times times) {
  if (numbers.size() < fewest_times) return {};
  std::vector<double> steps;
  steps.reserve(numbers.size() - 1);
  double risen = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    steps.push_back(numbers[i] - numbers[i - 1]);
    if (steps.back() >= 0) {
      risen += steps.back();
    } else if (times.steps_back++ == 0) {
      times.first_back_after = i - 1;
    }
  }
  const std::size_t most_back = times.is_named ? steps.size() / 10 : most_steps_back;
  if (times.steps_back > most_back) return {};
  times.step = usual_step(steps);
  times.samples = numbers.size();
  times.mean_step = risen / static_cast<double>(steps.size() - times.steps_back);
  if (times.step > 0) {
    look_for_gaps(steps, times);
    return times;
  }
  times.is_uneven = times.is_named && are_scattered(steps, times.mean_step);
  std::erase_if(steps, [](double step) { return step <= 0; });
  const bool are_times =
      times.is_named && !steps.empty() && risen >= fewest_coarse_steps * std::ranges::min(steps);
  return are_times ? times : Times{};
}

std::optional<TimesRate> contradicting_rate(const Times& times, double sample_rate_hz) {
  const double step = times.step > 0 ? times.step : times.mean_step;
  const bool may_count = times.is_named ? step == 1 : step == std::round(step);
  if (!(step > 0) || (times.unit_s == 0 && may_count)) return std::nullopt;
  TimesRate nearest;
  for (const double unit_s : likely_units_s) {
    if (times.unit_s > 0 && unit_s != times.unit_s) continue;
    // Dropped samples change the mean step; rounding changes the usual step.
    if (agree(times.step, unit_s, sample_rate_hz) || agree(times.mean_step, unit_s, sample_rate_hz))
      return std::nullopt;
    constexpr double longest_s = 1;
    if (unit_s > longest_s) continue;  // days count only if they agree
    const double hz = 1 / (step * unit_s);
    const auto distance = [&](double rate_hz) {
      return std::abs(std::log(rate_hz / sample_rate_hz));
    };
    if (nearest.hz == 0 || distance(hz) < distance(nearest.hz)) nearest = {hz, unit_s};
  }
  return nearest;
}

bool are_rounded(const Times& times, double sample_rate_hz) {
  constexpr double within = 1e-3;
  constexpr std::uint64_t samples_a_gap = 100;
  if (times.gaps * samples_a_gap < times.samples) return false;
  return std::ranges::any_of(likely_units_s, [&](double unit_s) {
    return agree(times.mean_step, unit_s, sample_rate_hz, within);
  });
}

}  // namespace piae::raw
