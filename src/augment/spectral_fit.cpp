#include "augment/spectral_fit.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "augment/line_minimum.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "spectra/power.hpp"

namespace piae::augment {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Longest sub-step of the solution of eq. 13 for the fit. Its error of 2 % is below the resolution
/// of the spectra.
constexpr double sub_step_s = 8e-6;
/// Number of half overlapping windows whose spectra are averaged. Together they cover more than
/// four turns of the cage of a 6205.
constexpr Index segments = 7;
/// Half the width of the smoothing, which blurs the lines of a fault into one resonance. A width of
/// 60 Hz fitted simulated windows less accurately.
constexpr double smoothing_hz = 120;
/// Bounds of the noise to signal power ratio, as natural logarithms: from no noise to only noise.
constexpr double lowest_log_noise = -16;
constexpr double highest_log_noise = 5;

/// Returns the power in the bins 1 .. length / 2. Bin 0 holds the mean and is left out.
ArrayXd power_of(const spectra::Windows& windows) {
  return spectra::mean_power_spectrum(windows).tail(windows.cols() / 2);
}

/// Returns the number of samples that the half overlapping windows of this length cover.
Index samples_of(Index length) { return length + (segments - 1) * (length / 2); }

/// Returns the power averaged over neighbouring bins with Hann weights.
ArrayXd smoothed(const ArrayXd& power, double bin_hz) {
  const auto reach = static_cast<Index>(std::ceil(smoothing_hz / bin_hz));
  ArrayXd weights(reach + 1);  // by the distance in bins
  for (Index i = 0; i <= reach; ++i) {
    const double distance = static_cast<double>(i) * bin_hz / smoothing_hz;
    weights[i] = distance < 1 ? 1 + std::cos(std::numbers::pi * distance) : 0;
  }
  ArrayXd result(power.size());
  for (Index i = 0; i < power.size(); ++i) {
    double sum = 0;
    double sum_of_weights = 0;
    for (Index j = std::max<Index>(0, i - reach); j <= std::min(power.size() - 1, i + reach); ++j) {
      const double weight = weights[std::abs(i - j)];
      sum = std::fma(weight, power[j], sum);
      sum_of_weights += weight;
    }
    result[i] = sum / sum_of_weights;
  }
  return result;
}

/// Returns the smoothed spectrum of a signal of samples_of(length) samples, scaled to mean 1.
ArrayXd spectrum_of(std::span<const double> signal, Index length, double sample_rate_hz) {
  spectra::Windows windows(segments, length);
  for (Index i = 0; i < segments; ++i) {
    windows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(&signal[i * (length / 2)], length);
  }
  const ArrayXd power = smoothed(power_of(windows), sample_rate_hz / static_cast<double>(length));
  return power / power.mean();
}

/// Returns Whittle's negative log-likelihood per bin, minimised over the scale a = mean of P / (S +
/// r).
double deviance(const ArrayXd& power, const ArrayXd& spectrum, double log_noise) {
  const ArrayXd model = spectrum + std::exp(log_noise);
  return model.log().mean() + std::log((power / model).mean());
}

/// Returns the deviance minimised over the noise r. `spectrum` has mean 1.
double deviance(const ArrayXd& power, const ArrayXd& spectrum) {
  LineMinimum line(lowest_log_noise, highest_log_noise, 8, 15);
  while (!line.done()) line.take(deviance(power, spectrum, line.next()));
  return deviance(power, spectrum, line.best());
}

void require_between(const std::string& option, double from, double to, const std::string& what) {
  if (from < to) return;
  throw Error(Exit::usage, fmt::format("{} {}: must be below {}, {}", option, from, to, what));
}

}  // namespace

void bind(const cli::Options& command, FitOptions& o) {
  command
      .add("--stiffness-from-n-per-m", o.stiffness_from_n_per_m,
           "least stiffness to search, N/m; the largest is load / clearance")
      .check(cli::positive_number());
  command.add("--damping-from-ns-per-m", o.damping_from_ns_per_m, "least damping to search, N s/m")
      .check(cli::positive_number());
  command.add("--damping-to-ns-per-m", o.damping_to_ns_per_m, "largest damping to search, N s/m")
      .check(cli::positive_number());
  command.add("--stiffness-grid", o.stiffness_grid, "values of k on the grid that starts the fit")
      .check(cli::whole_number(2, 1000));
  command.add("--damping-grid", o.damping_grid, "values of c on the grid that starts the fit")
      .check(cli::whole_number(2, 1000));
}

SpectralFit::SpectralFit(const signal::WindowSimulation& simulation, Label label,
                         const FitOptions& options)
    : info_(simulation.info), length_(simulation.length), dynamics_(simulation.options.dynamics) {
  const signal::ClassInfo& c = info_.classes.at(index_of(label));
  defect_ = {.fault_type = c.defect, .size_mm = c.defect_size_mm};
  dynamics_.max_sub_step_s = sub_step_s;
  const double largest_n_per_m = bearing::largest_stiffness_n_per_m(dynamics_);
  require_between("--stiffness-from-n-per-m", options.stiffness_from_n_per_m, largest_n_per_m,
                  "load / clearance; above it, balls never touch the races");
  require_between("--damping-from-ns-per-m", options.damping_from_ns_per_m,
                  options.damping_to_ns_per_m, "--damping-to-ns-per-m");
  low_ = {.log_k = std::log(options.stiffness_from_n_per_m),
          .log_c = std::log(options.damping_from_ns_per_m)};
  high_ = {.log_k = std::log(largest_n_per_m), .log_c = std::log(options.damping_to_ns_per_m)};
  step_ = {.log_k = (high_.log_k - low_.log_k) / (options.stiffness_grid - 1),
           .log_c = (high_.log_c - low_.log_c) / (options.damping_grid - 1)};
  for (int i = 0; i < options.stiffness_grid; ++i) {
    for (int j = 0; j < options.damping_grid; ++j) {
      grid_.push_back({low_.log_k + i * step_.log_k, low_.log_c + j * step_.log_c});
    }
  }
  spectra_.resize(grid_.size());
  parallel_for_parts(1, grid_.size(), bearing::courses_at_once,
                     [&](std::size_t first, std::size_t count) {
                       std::ranges::move(solved_spectra(std::span(grid_).subspan(first, count)),
                                         spectra_.begin() + static_cast<Index>(first));
                     });
}

std::vector<ArrayXd> SpectralFit::solved_spectra(std::span<const Point> points) const {
  std::vector<bearing::Course> courses;
  for (const Point& point : points) {
    bearing::DynamicsOptions dynamics = dynamics_;
    dynamics.stiffness_n_per_m = std::exp(point.log_k);
    dynamics.damping_ns_per_m = std::exp(point.log_c);
    courses.push_back({{.shaft_speed_rpm = info_.known_speed_rpm()}, dynamics});
  }
  const auto length = static_cast<Index>(length_);
  const auto samples = static_cast<std::size_t>(samples_of(length));
  const std::vector<double> signals =
      bearing::simulate(info_.bearing, defect_, courses, {info_.sample_rate_hz, samples});
  std::vector<ArrayXd> spectra;
  for (std::size_t i = 0; i < points.size(); ++i) {
    spectra.push_back(spectrum_of(std::span(signals).subspan(i * samples, samples), length,
                                  info_.sample_rate_hz));
  }
  return spectra;
}

SpectralFit::Point SpectralFit::best_of_grid(const ArrayXd& power) const {
  std::vector<double> deviances;
  for (const ArrayXd& spectrum : spectra_) deviances.push_back(deviance(power, spectrum));
  return grid_[static_cast<std::size_t>(std::ranges::min_element(deviances) - deviances.begin())];
}

/// Searches one window's best point, starting at the best grid point, along one coordinate after
/// the other. next() returns the point at which the search needs the spectrum.
class SpectralFit::Search {
 public:
  Search(const SpectralFit& fit, Window window)
      : fit_(&fit), power_(power_of(row(window))), point_(fit.best_of_grid(power_)) {}

  [[nodiscard]] bool done() const { return leg_ == std::size(legs); }
  [[nodiscard]] Point next() const { return moved(line_.next()); }
  void take(const ArrayXd& spectrum) {
    line_.take(deviance(power_, spectrum));
    if (!line_.done()) return;
    point_ = moved(line_.best());
    line_ = new_line();
    ++leg_;
  }
  [[nodiscard]] signal::DynamicParameters best() const {
    return {.stiffness_n_per_m = std::exp(point_.log_k),
            .damping_ns_per_m = std::exp(point_.log_c)};
  }

 private:
  static constexpr double Point::*legs[] = {&Point::log_k, &Point::log_c, &Point::log_k,
                                            &Point::log_c};

  static spectra::Windows row(Window window) {
    return Eigen::Map<const Eigen::RowVectorXf>(window.data(), static_cast<Index>(window.size()))
        .cast<double>();
  }
  // The variable counts grid steps from the point, because Brent's tolerance is relative to the
  // variable: for a log k near 18 the tolerance would exceed the grid.
  static LineMinimum new_line() { return {-1, 1, 6, 8}; }
  [[nodiscard]] Point moved(double steps) const {
    double Point::*const coordinate = legs[leg_];
    Point result = point_;
    result.*coordinate = std::clamp(point_.*coordinate + steps * fit_->step_.*coordinate,
                                    fit_->low_.*coordinate, fit_->high_.*coordinate);
    return result;
  }

  const SpectralFit* fit_;
  ArrayXd power_;
  Point point_;  ///< start of the current leg
  std::size_t leg_ = 0;
  LineMinimum line_ = new_line();
};

std::vector<signal::DynamicParameters> SpectralFit::fit(const std::vector<Window>& windows) const {
  std::vector<Search> searches;
  searches.reserve(windows.size());
  for (const Window window : windows) searches.emplace_back(*this, window);
  while (true) {
    std::vector<Search*> open;
    std::vector<Point> points;
    for (Search& search : searches) {
      if (search.done() || open.size() == bearing::courses_at_once) continue;
      open.push_back(&search);
      points.push_back(search.next());
    }
    if (open.empty()) break;
    const std::vector<ArrayXd> spectra = solved_spectra(points);
    for (std::size_t i = 0; i < open.size(); ++i) open[i]->take(spectra[i]);
  }
  std::vector<signal::DynamicParameters> fitted;
  fitted.reserve(searches.size());
  for (const Search& search : searches) fitted.push_back(search.best());
  return fitted;
}

}  // namespace piae::augment
