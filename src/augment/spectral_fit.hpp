#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

/// Search ranges of stiffness and damping. The paper gives no bounds. Physics gives the largest
/// stiffness: unless k * clearance < W, no ball is ever touched.
struct FitOptions {
  double stiffness_from_n_per_m = 2e7;  ///< below, the balls alone hold the ring: k has no effect
  double damping_from_ns_per_m = 100;   ///< about 0.5 % of critical for M = 1 kg, k = 1e8 N/m
  double damping_to_ns_per_m = 5000;    ///< about 25 %: a burst dies out within one oscillation
  int stiffness_grid = 24;              ///< grid values between the bounds, in equal ratios
  int damping_grid = 10;                ///< the same for damping
};

void bind(const cli::Options& command, FitOptions& options);

/// Fits (k, c) to a window by eq. 13 itself: finds the argmax of p(k, c
///  x) of eq. 14 with a flat prior in log k and log c. The shaft angle at the window's start is
///  unknown, so only the window's periodogram P is compared, by Whittle's likelihood (1953): the
///  mean over the bins of log M + P / M. Here M = a (S + r), where S is the smoothed mean spectrum
///  of a long solution of eq. 13 and r is white noise. The scale a (the path to the sensor is
///  unknown) and the noise r take their best values for each (k, c). The search covers a grid
///  first, then continues by Brent's method, one coordinate after the other.
///
/// Accuracy, measured on 576 simulated windows of 1024 samples (7 and 21 mil defects, k from 5e7 to
/// 3.5e8 N/m, c from 250 to 1500 N s/m, random angles and slip, without noise and with noise 10 dB
/// below the signal):
///   - k: within 1 % in the median, 9 of 10 within 7 %, at worst 34 %. At 5e7 N/m, where the balls
///     carry the ring as much as k does, within 6 % in the median and 9 of 10 within 9 %.
///   - c of race defects: within 7 to 17 % in the median, 9 of 10 within a factor of 1.7, at worst
///     within 5.
///   - c of roller defects, which may cause almost no impacts in a window: within a factor of 1.2
///     to 1.5 in the median, 9 of 10 within 3, at worst within 14.
class SpectralFit {
 public:
  /// Solves eq. 13 over the grid for the defect of a class, in parallel by OpenMP. Throws
  /// Error(usage) if a lower bound is not below its upper bound.
  SpectralFit(const signal::WindowSimulation& simulation, Label label, const FitOptions& options);

  using Window = std::span<const float>;
  /// Fits windows of the simulation's length. After the grid, bearing::courses_at_once searches run
  /// together, because eq. 13 is solved for that many at once. The result of a window does not
  /// depend on the others, bit for bit.
  [[nodiscard]] std::vector<signal::DynamicParameters> fit(
      const std::vector<Window>& windows) const;

 private:
  class Search;
  /// Coordinates of the search; equal steps are equal ratios.
  struct Point {
    double log_k = 0;
    double log_c = 0;
  };

  [[nodiscard]] std::vector<Eigen::ArrayXd> solved_spectra(std::span<const Point> points) const;
  [[nodiscard]] Point best_of_grid(const Eigen::ArrayXd& power) const;

  signal::DatasetInfo info_;
  std::size_t length_;
  bearing::DynamicsOptions dynamics_;
  bearing::LocalDefect defect_;
  Point low_;
  Point high_;
  Point step_;
  std::vector<Point> grid_;
  std::vector<Eigen::ArrayXd> spectra_;
};

}  // namespace piae::augment
