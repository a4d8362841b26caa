#include "symptoms/baseline.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/error.hpp"

namespace piae::symptoms {

namespace {

constexpr double equal_speeds = 0.02;
constexpr double least_deviation = 1e-6;  // where all healthy windows are the same

using Row = Eigen::ArrayXd Measures::*;

/// A row for each window.
Eigen::ArrayXXd rows_of(const std::vector<const Measures*>& windows, Row row) {
  Eigen::ArrayXXd rows(windows.size(), (windows.front()->*row).size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = (windows[i]->*row).transpose();
  }
  return rows;
}

/// Where a window was cut, where that is known: windows so ordered are in the order of time.
std::tuple<std::int32_t, std::int64_t> place_of(const signal::WindowSet& windows, std::size_t i) {
  if (windows.record.empty() || windows.first_sample.empty()) return {};
  return {windows.record[i], windows.first_sample[i]};
}

}  // namespace

Baseline::Baseline(const std::vector<const Measures*>& healthy)
    : novelty_(rows_of(healthy, &Measures::shape_db)),
      levels_db_(rows_of(healthy, &Measures::levels_db).colwise().mean()) {
  for (std::size_t kind = 0; kind < number_of_kinds; ++kind) {
    Eigen::ArrayXd lines(healthy.size());
    std::ranges::transform(healthy, lines.begin(),
                           [&](const Measures* window) { return window->lines.at(kind); });
    mean_.at(kind) = lines.mean();
    deviation_.at(kind) =
        std::max(std::sqrt((lines - lines.mean()).square().mean()), least_deviation);
  }
}

std::array<double, number_of_kinds> Baseline::excesses(const Measures& window) const {
  std::array<double, number_of_kinds> excesses{};
  for (std::size_t kind = 0; kind < number_of_kinds; ++kind) {
    excesses.at(kind) = (window.lines.at(kind) - mean_.at(kind)) / deviation_.at(kind);
  }
  return excesses;
}

Eigen::ArrayXd Baseline::rise_db(const Measures& window) const {
  return window.levels_db - levels_db_;
}

bool is_same_speed(double speed_rpm, double other_rpm) {
  return std::abs(speed_rpm - other_rpm) <= equal_speeds * other_rpm;
}

Baselines::Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures)
    : windows_(&windows),
      measures_(&measures),
      healthy_(windows.indices_of(windows.info.healthy_label())) {
  if (healthy_.size() < fewest_healthy) {
    throw Error(Exit::bad_input,
                fmt::format("{} healthy windows are too few to compare others with; {} or more "
                            "would do",
                            healthy_.size(), fewest_healthy));
  }
  std::ranges::stable_sort(healthy_, {}, [&](std::size_t i) { return place_of(windows, i); });
}

Baselines::Indices Baselines::near(double speed_rpm) const {
  Indices alike;
  std::ranges::copy_if(healthy_, std::back_inserter(alike), [&](std::size_t i) {
    return is_same_speed(windows_->speed_rpm(i), speed_rpm);
  });
  return alike.size() < fewest_healthy ? healthy_ : alike;
}

const Baseline& Baselines::of(const Indices& healthy) {
  const auto made = made_.find(healthy);
  if (made != made_.end()) return made->second;
  std::vector<const Measures*> rows(healthy.size());
  std::ranges::transform(healthy, rows.begin(), [&](std::size_t i) { return &(*measures_)[i]; });
  return made_.emplace(healthy, rows).first->second;
}

const Baseline& Baselines::at(double speed_rpm) { return of(near(speed_rpm)); }

double Baselines::left_out(std::size_t window) {
  const Indices alike = near(windows_->speed_rpm(window));
  const auto place = std::ranges::find(alike, window) - alike.begin();
  return of(alike).novelty().of_healthy()[place];
}

}  // namespace piae::symptoms
