#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/window_set.hpp"
#include "symptoms/measures.hpp"
#include "symptoms/novelty.hpp"

namespace piae::symptoms {

/// Common properties of the healthy windows of one speed, for comparison with windows of the same
/// or another speed. Lines lie at orders of the shaft, which do not depend on the speed; levels and
/// shapes of spectra may differ by speed_change.hpp.
class Baseline {
 public:
  /// Takes at least 4 healthy windows in order of time. `speed_ratio` is the speed of the windows
  /// to be compared over that of the healthy ones.
  explicit Baseline(const std::vector<const Measures*>& healthy, double speed_ratio = 1);

  /// Returns the height of each fault type's line above the healthy mean, in healthy standard
  /// deviations.
  [[nodiscard]] std::array<double, number_of_fault_types> excesses(const Measures& window) const;
  [[nodiscard]] const Novelty& novelty() const { return novelty_; }
  /// Returns [bands] the levels of a window above the mean of the healthy ones, in dB. At another
  /// speed, only what exceeds the change by the speed counts.
  [[nodiscard]] Eigen::ArrayXd rise_db(const Measures& window) const;

 private:
  std::array<double, number_of_fault_types> mean_{};
  std::array<double, number_of_fault_types> deviation_{};
  Novelty novelty_;
  Eigen::ArrayXd levels_db_;
  Eigen::ArrayXd change_db_;
};

/// Attribute of a group with baselines.
inline constexpr const char* prewhitening_name = "prewhitening";

/// Least number of healthy windows for a comparison.
inline constexpr std::size_t fewest_healthy = 8;

/// True if a speed is within 2 % of the other one, and so shares its baseline.
bool is_same_speed(double speed_rpm, double other_rpm);

/// Healthy windows of a set. Each window is compared with those of its own speed; if fewer than
/// eight have it, with those of the nearest speed that eight or more have, else with all of them.
class Baselines {
 public:
  /// Takes the healthy windows of a set, which may hold others; `measures` are of all its windows,
  /// measured with this `prewhitening`. Throws Error(bad_input) for fewer than eight healthy
  /// windows.
  Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures,
            double prewhitening = 0);

  /// Returns the prewhitening with which windows must be measured to be compared.
  [[nodiscard]] double prewhitening() const { return prewhitening_; }

  /// Returns the baseline of a speed.
  const Baseline& at(double speed_rpm);
  /// Returns the novelty of a healthy window of the set, by its index there, when its block among
  /// the windows of its speed is left out.
  double left_out(std::size_t window);

  /// Writes the healthy windows in order of time below a group: /speed_rpm [n], /lines [n, 3],
  /// /shape_db [n, 48] and /levels_db [n, bands]; the attribute prewhitening unless it is 0.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Reads the baselines of windows at this sample rate. Throws artefact::Refusal for impossible
  /// shapes or speeds, and for fewer than eight windows.
  static Baselines read(const artefact::Reader& reader, const std::string& group, double rate_hz);

 private:
  using Indices = std::vector<std::size_t>;
  Baselines() = default;
  [[nodiscard]] Indices alike(double speed_rpm) const;
  [[nodiscard]] Indices nearest(double speed_rpm) const;
  const Baseline& of(const Indices& healthy, double speed_rpm);

  double prewhitening_ = 0;
  // Healthy windows in order of time:
  std::vector<double> speeds_rpm_;
  std::vector<Measures> measures_;
  std::map<std::size_t, std::size_t> places_;            ///< index in the set to index here
  std::map<std::pair<Indices, double>, Baseline> made_;  ///< by windows and ratio of speeds
};

}  // namespace piae::symptoms
