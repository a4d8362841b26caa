#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "signal/window_set.hpp"
#include "symptoms/measures.hpp"
#include "symptoms/novelty.hpp"

namespace piae::symptoms {

/// What healthy windows of one speed have in common.
class Baseline {
 public:
  /// `healthy` in the order of time, at least 4.
  explicit Baseline(const std::vector<const Measures*>& healthy);

  /// How many standard deviations of the healthy windows the line of each kind stands above their
  /// mean.
  [[nodiscard]] std::array<double, number_of_kinds> excesses(const Measures& window) const;
  [[nodiscard]] const Novelty& novelty() const { return novelty_; }
  /// [bands] by how many dB a window's levels exceed the mean of the healthy ones.
  [[nodiscard]] Eigen::ArrayXd rise_db(const Measures& window) const;

 private:
  std::array<double, number_of_kinds> mean_{};
  std::array<double, number_of_kinds> deviation_{};
  Novelty novelty_;
  Eigen::ArrayXd levels_db_;
};

/// The fewest healthy windows that something can be compared with.
inline constexpr std::size_t fewest_healthy = 8;

/// Whether a speed is, for a baseline, the same as another: within 2 % of that.
bool is_same_speed(double speed_rpm, double other_rpm);

/// The healthy windows of a set, from which each window is compared with those of its own speed.
/// Where fewer than eight are, it is compared with all of them.
class Baselines {
 public:
  /// Of the windows of the healthy class in a set, which may hold others; `measures` are of all its
  /// windows and must outlive this. Throws Error(bad_input) for fewer than eight healthy windows.
  Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures);

  /// The baseline of a speed.
  const Baseline& at(double speed_rpm);
  /// The novelty of a healthy window of the set, by its index there, when its block of the windows
  /// of its speed is left out.
  double left_out(std::size_t window);

 private:
  using Indices = std::vector<std::size_t>;
  [[nodiscard]] Indices near(double speed_rpm) const;
  const Baseline& of(const Indices& healthy);

  const signal::WindowSet* windows_;
  const std::vector<Measures>* measures_;
  Indices healthy_;  ///< in the order of time
  std::map<Indices, Baseline> made_;
};

}  // namespace piae::symptoms
