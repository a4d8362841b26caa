#include "symptoms/baseline.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "signal/ranges.hpp"
#include "spectra/bands.hpp"
#include "symptoms/speed_change.hpp"

namespace piae::symptoms {

namespace {

constexpr double equal_speeds = 0.02;
constexpr double ratio_step = 0.01;  // of the logarithm, so that drifting speeds share baselines
constexpr double least_deviation = 1e-6;  // if all healthy windows are the same

using Row = Eigen::ArrayXd Measures::*;

/// Returns a row for each window.
Eigen::ArrayXXd rows_of(const std::vector<const Measures*>& windows, Row row) {
  Eigen::ArrayXXd rows(windows.size(), (windows.front()->*row).size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = (windows[i]->*row).transpose();
  }
  return rows;
}

}  // namespace

Baseline::Baseline(const std::vector<const Measures*>& healthy, double speed_ratio)
    : novelty_(rows_of(healthy, &Measures::shape_db), speed_ratio),
      levels_db_(rows_of(healthy, &Measures::levels_db).colwise().mean()),
      change_db_(change_db(levels_db_, places_of_levels(), speed_ratio)) {
  for (std::size_t fault_type = 0; fault_type < number_of_fault_types; ++fault_type) {
    Eigen::ArrayXd lines(healthy.size());
    std::ranges::transform(healthy, lines.begin(),
                           [&](const Measures* window) { return window->lines.at(fault_type); });
    mean_.at(fault_type) = lines.mean();
    deviation_.at(fault_type) =
        std::max(std::sqrt((lines - lines.mean()).square().mean()), least_deviation);
  }
}

std::array<double, number_of_fault_types> Baseline::excesses(const Measures& window) const {
  std::array<double, number_of_fault_types> excesses{};
  for (std::size_t fault_type = 0; fault_type < number_of_fault_types; ++fault_type) {
    excesses.at(fault_type) =
        (window.lines.at(fault_type) - mean_.at(fault_type)) / deviation_.at(fault_type);
  }
  return excesses;
}

Eigen::ArrayXd Baseline::rise_db(const Measures& window) const {
  const Eigen::ArrayXd rise = window.levels_db - levels_db_;
  return rise.sign() * (rise.abs() - change_db_).max(0);
}

bool is_same_speed(double speed_rpm, double other_rpm) {
  return std::abs(speed_rpm - other_rpm) <= equal_speeds * other_rpm;
}

Baselines::Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures,
                     double prewhitening)
    : prewhitening_(prewhitening) {
  const Label healthy = windows.info.healthy_label();
  if (windows.count_of(healthy) < fewest_healthy) {
    throw Error(Exit::bad_input,
                fmt::format("{} healthy windows are too few for a baseline; use {} or more",
                            windows.count_of(healthy), fewest_healthy));
  }
  for (const std::size_t i : signal::in_time_order(windows)) {
    if (windows.labels[i] != healthy) continue;
    places_.emplace(i, measures_.size());
    speeds_rpm_.push_back(windows.speed_rpm(i));
    measures_.push_back(measures[i]);
  }
}

Baselines::Indices Baselines::alike(double speed_rpm) const {
  Indices alike;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    if (is_same_speed(speeds_rpm_[i], speed_rpm)) alike.push_back(i);
  }
  return alike;
}

Baselines::Indices Baselines::nearest(double speed_rpm) const {
  Indices own = alike(speed_rpm);
  if (own.size() >= fewest_healthy) return own;
  std::vector<double> by_distance = speeds_rpm_;
  std::ranges::sort(by_distance, {},
                    [&](double other) { return std::abs(std::log(other / speed_rpm)); });
  for (const double other : by_distance) {
    Indices of_other = alike(other);
    if (of_other.size() >= fewest_healthy) return of_other;
  }
  Indices all(measures_.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

const Baseline& Baselines::of(const Indices& healthy, double speed_rpm) {
  double mean_rpm = 0;
  for (const std::size_t i : healthy)
    mean_rpm += speeds_rpm_[i] / static_cast<double>(healthy.size());
  const bool is_same = is_same_speed(mean_rpm, speed_rpm);
  const double ratio =
      is_same ? 1 : std::exp(ratio_step * std::round(std::log(speed_rpm / mean_rpm) / ratio_step));
  const auto made = made_.find({healthy, ratio});
  if (made != made_.end()) return made->second;
  std::vector<const Measures*> rows(healthy.size());
  std::ranges::transform(healthy, rows.begin(), [&](std::size_t i) { return &measures_[i]; });
  return made_.emplace(std::pair(healthy, ratio), Baseline(rows, ratio)).first->second;
}

const Baseline& Baselines::at(double speed_rpm) { return of(nearest(speed_rpm), speed_rpm); }

double Baselines::left_out(std::size_t window) {
  const std::size_t own = places_.at(window);
  const Indices healthy = nearest(speeds_rpm_[own]);
  const Novelty& novelty = of(healthy, speeds_rpm_[own]).novelty();
  const auto place = std::ranges::find(healthy, own);
  return place == healthy.end() ? novelty.of(measures_[own].shape_db)
                                : novelty.of_healthy()[place - healthy.begin()];
}

void Baselines::write(artefact::Writer& writer, const std::string& group) const {
  std::vector<double> lines;
  std::vector<double> shapes;
  std::vector<double> levels;
  for (const Measures& window : measures_) {
    lines.insert(lines.end(), window.lines.begin(), window.lines.end());
    shapes.insert(shapes.end(), window.shape_db.begin(), window.shape_db.end());
    levels.insert(levels.end(), window.levels_db.begin(), window.levels_db.end());
  }
  const std::size_t n = measures_.size();
  writer.numbers(group + "/speed_rpm", speeds_rpm_);
  writer.numbers(group + "/lines", lines, {n, number_of_fault_types});
  writer.numbers(group + "/shape_db", shapes, {n, shapes.size() / n});
  writer.numbers(group + "/levels_db", levels, {n, levels.size() / n});
  if (prewhitening_ > 0) writer.attribute(group, prewhitening_name, prewhitening_);
}

Baselines Baselines::read(const artefact::Reader& reader, const std::string& group,
                          double rate_hz) {
  Baselines read;
  // Classifiers kept before this attribute existed did not prewhiten.
  if (reader.has_attribute(group, prewhitening_name)) {
    read.prewhitening_ = reader.real(group, prewhitening_name, possible_prewhitening);
  }
  read.speeds_rpm_ = reader.numbers<double>(group + "/speed_rpm", {0}).values;
  reader.require_all(group + "/speed_rpm", read.speeds_rpm_, signal::ranges::shaft_speed_rpm);
  const std::size_t n = read.speeds_rpm_.size();
  if (n < fewest_healthy) {
    reader.refuse(group + "/speed_rpm",
                  fmt::format("has {} healthy windows, but needs {} or more", n, fewest_healthy));
  }
  const auto lines = reader.numbers<double>(group + "/lines", {n, number_of_fault_types}).values;
  const auto shapes =
      reader.numbers<double>(group + "/shape_db", {n, std::size_t{spectra::spectral_shape_bands}});
  const auto levels =
      reader.numbers<double>(group + "/levels_db", {n, spectra::narrow_bands(rate_hz).size()});
  const auto row_of = [](const artefact::Array<double>& rows, std::size_t i) {
    const auto columns = static_cast<Eigen::Index>(rows.shape[1]);
    return Eigen::Map<const Eigen::ArrayXd>(rows.values.data() + i * rows.shape[1], columns);
  };
  for (std::size_t i = 0; i < n; ++i) {
    Measures window;
    std::copy_n(lines.begin() + static_cast<std::ptrdiff_t>(i * number_of_fault_types),
                number_of_fault_types, window.lines.begin());
    window.shape_db = row_of(shapes, i);
    window.levels_db = row_of(levels, i);
    read.measures_.push_back(window);
  }
  return read;
}

}  // namespace piae::symptoms
