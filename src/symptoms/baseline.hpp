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
  /// windows. Throws Error(bad_input) for fewer than eight healthy windows.
  Baselines(const signal::WindowSet& windows, const std::vector<Measures>& measures);

  /// The baseline of a speed.
  const Baseline& at(double speed_rpm);
  /// The novelty of a healthy window of the set, by its index there, when its block of the windows
  /// of its speed is left out.
  double left_out(std::size_t window);

  /// What is compared with, below a group: /speed_rpm [n], /lines [n, 3], /shape_db [n, 48] and
  /// /levels_db [n, bands] of the healthy windows in the order of time.
  void write(artefact::Writer& writer, const std::string& group) const;
  /// Of windows at this sample rate. Throws artefact::Refusal for shapes that cannot be, fewer than
  /// eight windows, and a speed that cannot be.
  static Baselines read(const artefact::Reader& reader, const std::string& group, double rate_hz);

 private:
  using Indices = std::vector<std::size_t>;
  Baselines() = default;
  [[nodiscard]] Indices near(double speed_rpm) const;
  const Baseline& of(const Indices& healthy);

  // The healthy windows in the order of time:
  std::vector<double> speeds_rpm_;
  std::vector<Measures> measures_;
  std::map<std::size_t, std::size_t> places_;  ///< of a window of the set among them
  std::map<Indices, Baseline> made_;
};

}  // namespace piae::symptoms
