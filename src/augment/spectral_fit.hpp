#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

/// Where stiffness and damping are looked for. The paper gives no bounds; from above the stiffness
/// is bounded by physics: k * clearance < W, or no ball is ever touched.
struct FitOptions {
  double stiffness_from_n_per_m = 2e7;  ///< below, the balls alone hold the ring: k is not seen
  double damping_from_ns_per_m = 100;   ///< about 0.5 % of critical for M = 1 kg, k = 1e8 N/m
  double damping_to_ns_per_m = 5000;    ///< about 25 %: a burst dies out within one oscillation
  int stiffness_grid = 24;              ///< values between the bounds, in equal ratios
  int damping_grid = 10;
};

void bind(const cli::Options& command, FitOptions& options);

/// (k, c) of a window by eq. 13 itself: eq. 14's argmax of p(k, c | x) with a flat prior in log k
/// and log c. Where on the shaft's turn a window starts is unknown, so it is judged by its
/// periodogram alone, with Whittle's likelihood (1953): mean over the bins of log M + P / M, where
/// P is the window's periodogram and M = a (S + r) is the smoothed mean spectrum S of a long
/// solution of eq. 13 plus white noise; the scale a (unknown path to the sensor) and the noise r
/// are profiled out. Searched on a grid first, then by Brent's method, one coordinate after the
/// other.
///
/// How well it finds known values, on 576 simulated windows of 1024 (7 and 21 mil defects, k 5e7 to
/// 3.5e8 N/m, c 250 to 1500 N s/m, random angles and slip, without noise and with noise 10 dB
/// below): k to 1 % in the median and 9 in 10 within 7 % (at 5e7 N/m, where the balls hold the ring
/// as much as k does, to 6 % and 9 %), at worst 34 %. c of race defects to 7 to 17 % in the median,
/// 9 in 10 within a factor of 1.7, at worst 5. c of roller defects is poorly seen, since the defect
/// may hardly strike in a window: to a factor of 1.2 to 1.5 in the median, 9 in 10 within 3, at
/// worst 14.
class SpectralFit {
 public:
  /// Solves eq. 13 over the grid for the defect of a class, OpenMP parallel. Throws Error(usage)
  /// when the bounds leave nothing between them.
  SpectralFit(const signal::WindowSimulation& simulation, int label, const FitOptions& options);

  /// `window` has the simulation's length.
  [[nodiscard]] signal::DynamicParameters fit(std::span<const float> window) const;

 private:
  /// Coordinates of the search: equal steps are equal ratios.
  struct Point {
    double log_k = 0;
    double log_c = 0;
  };

  [[nodiscard]] std::vector<Eigen::ArrayXd> solved_spectra(std::span<const Point> points) const;
  [[nodiscard]] Point best_of_grid(const Eigen::ArrayXd& power) const;
  void refine(const Eigen::ArrayXd& power, Point& point, double Point::*coordinate) const;

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
