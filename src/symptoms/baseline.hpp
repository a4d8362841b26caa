#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "signal/window_set.hpp"
#include "symptoms/measures.hpp"
#include "symptoms/novelty.hpp"

namespace piae::symptoms {

/// Common properties of the healthy windows of one speed.
class Baseline {
 public:
  /// Takes at least 4 healthy windows in order of time.
  explicit Baseline(const std::vector<const Measures*>& healthy);

  /// Returns the height of each fault type's line above the healthy mean, in healthy standard
  /// deviations.
  [[nodiscard]] std::array<double, number_of_fault_types> excesses(const Measures& window) const;
  [[nodiscard]] const Novelty& novelty() const { return novelty_; }
  /// Returns [bands] the levels of a window above the mean of the healthy ones, in dB.
  [[nodiscard]] Eigen::ArrayXd rise_db(const Measures& window) const;

 private:
  std::array<double, number_of_fault_types> mean_{};
  std::array<double, number_of_fault_types> deviation_{};
  Novelty novelty_;
  Eigen::ArrayXd levels_db_;
};

/// Least number of healthy windows for a comparison.
inline constexpr std::size_t fewest_healthy = 8;

/// True if a speed is within 2 % of the other one, and so shares its baseline.
bool is_same_speed(double speed_rpm, double other_rpm);

/// Healthy windows of a set. Each window is compared with those of its own speed, or with all of
/// them if fewer than eight have its speed.
class Baselines {
 public:
  /// Takes the healthy windows of a set, which may hold others; `measures` are of all its windows.
  /// Throws Error(bad_input) for fewer than eight healthy windows.
  Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures);

  /// Returns the baseline of a speed.
  const Baseline& at(double speed_rpm);
  /// Returns the novelty of a healthy window of the set, by its index there, when its block among
  /// the windows of its speed is left out.
  double left_out(std::size_t window);

  /// Writes the healthy windows in order of time below a group: /speed_rpm [n], /lines [n, 3],
  /// /shape_db [n, 48] and /levels_db [n, bands].
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Reads the baselines of windows at this sample rate. Throws artefact::Refusal for impossible
  /// shapes or speeds, and for fewer than eight windows.
  static Baselines read(const artefact::Reader& reader, const std::string& group, double rate_hz);

 private:
  using Indices = std::vector<std::size_t>;
  Baselines() = default;
  [[nodiscard]] Indices near(double speed_rpm) const;
  const Baseline& of(const Indices& healthy);

  // Healthy windows in order of time:
  std::vector<double> speeds_rpm_;
  std::vector<Measures> measures_;
  std::map<std::size_t, std::size_t> places_;  ///< index in the set to index here
  std::map<Indices, Baseline> made_;
};

}  // namespace piae::symptoms
