#include "signal/machine.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/comma_list.hpp"
#include "base/error.hpp"
#include "base/range.hpp"
#include "bearing/kinematics.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

constexpr double stretch_s = 1;
/// Limit of deviations in standard deviations, as in simulated records.
constexpr double cut_at = 1 / bearing::spread_limit;

/// Returns the time in s after which the initial state has decayed; at most one stretch.
double settling_s(const bearing::DynamicsOptions& dynamics, double damping_spread) {
  const double least_damping = dynamics.damping_ns_per_m * (1 - cut_at * damping_spread);
  const double time_constant_s = 2 * dynamics.mass_kg / least_damping;
  return std::min(12 * time_constant_s, stretch_s);
}

double scattered(double mean, double spread, double deviation) {
  return mean * (1 + spread * std::clamp(deviation, -cut_at, cut_at));
}

/// Returns the standard normal probability below a deviation.
double share_below(double deviation) { return std::erfc(-deviation / std::numbers::sqrt2) / 2; }

double turned_by(double angle_rad, double by_rad) {
  return std::remainder(angle_rad + by_rad, 2 * std::numbers::pi);
}

const ClassInfo& class_called(const DatasetInfo& info, const std::string& name) {
  const auto found = std::ranges::find(info.classes, name, &ClassInfo::name);
  if (found != info.classes.end()) return *found;
  throw Error(Exit::usage, fmt::format("--stream {}: {} has no such class; it has {}", name,
                                       info.name, comma_list(info.classes, &ClassInfo::name)));
}

std::uint64_t samples_in(double time_s, double rate_hz) {
  return static_cast<std::uint64_t>(std::llround(time_s * rate_hz));
}

}  // namespace

void bind(const cli::Options& command, MachineOptions& options) {
  constexpr Range duration_s{.low = 0.1, .high = 1e8, .unit = " s"};
  constexpr Range appears_at_s{.low = 0, .high = 1e8, .unit = " s"};
  constexpr Range drift_s{.low = 10, .high = 1e12, .unit = " s"};
  command.add("--duration-s", options.duration_s, "length of the stream, s")
      .check(cli::within(duration_s));
  command
      .add("--appears-at-s", options.appears_at_s,
           "time at which the defect appears, s; the bearing is healthy before")
      .check(cli::within(appears_at_s));
  command
      .add("--drift-s", options.drift_s,
           "time constant of stiffness, damping, speed and slip, s: their correlation falls to "
           "1/e; they spread as between records of the data set")
      .check(cli::within(drift_s));
  command.add("--seed", options.seed, "number of the machine; each seed makes another one")
      .check(cli::within(ranges::seed));
}

Machine::Machine(const Simulation& simulation, const std::string& class_name,
                 const MachineOptions& options)
    : simulation_(simulation),
      correlation_(std::exp(-stretch_s / options.drift_s)),
      stretch_(std::max<std::size_t>(1, samples_in(stretch_s, simulation.info.sample_rate_hz))),
      samples_(samples_in(options.duration_s, simulation.info.sample_rate_hz)),
      onset_(samples_in(options.appears_at_s, simulation.info.sample_rate_hz)),
      dynamics_(simulation.dynamics),
      drift_(fmt::format("{}/seed{}/machine/drift", simulation.info.name, options.seed)),
      noise_(fmt::format("{}/seed{}/machine/noise", simulation.info.name, options.seed)) {
  const ClassInfo& c = class_called(simulation.info, class_name);
  defect_ = {c.defect, c.defect_size_mm};
  if (c.defect == Defect::none) {
    onset_ = samples_;
  } else if (onset_ >= samples_) {
    throw Error(Exit::usage,
                fmt::format("--appears-at-s {:g}: the machine runs for {:g} s only; choose an "
                            "earlier time, or a longer --duration-s",
                            options.appears_at_s, options.duration_s));
  }
  dynamics_.settling_s = settling_s(simulation.dynamics, simulation.variation.damping_spread);
  Stream angles(fmt::format("{}/seed{}/machine/angles", simulation.info.name, options.seed));
  motion_.cage_angle_rad = angles.uniform(0, 2 * std::numbers::pi);
  const double defect_angle_rad = angles.uniform(0, 2 * std::numbers::pi);
  if (c.defect != Defect::outer) motion_.defect_angle_rad = defect_angle_rad;
  for (double& deviation : deviations_) deviation = drift_.normal(0, 1);
  noise_deviation_ = measurement_noise(simulation);
}

/// Returns the samples of the next stretch, which ends early at the onset and at the end.
std::size_t Machine::next_length() const {
  const std::uint64_t border = done_ < onset_ ? onset_ : samples_;
  return static_cast<std::size_t>(std::min<std::uint64_t>(stretch_, border - done_));
}

bearing::Course Machine::course() const {
  const bearing::Variation& variation = simulation_.variation;
  bearing::Course course{motion_, dynamics_};
  course.options.stiffness_n_per_m =
      scattered(dynamics_.stiffness_n_per_m, variation.stiffness_spread, deviations_[0]);
  course.options.damping_ns_per_m =
      scattered(dynamics_.damping_ns_per_m, variation.damping_spread, deviations_[1]);
  course.motion.shaft_speed_rpm =
      scattered(simulation_.info.shaft_speed_rpm, variation.speed_spread, deviations_[2]);
  course.motion.slip = variation.slip_max * share_below(deviations_[3]);
  return course;
}

/// Advances to the end of a stretch and draws the deviations of the next.
void Machine::run_on(std::size_t samples) {
  const bearing::Motion now = course().motion;
  const bearing::Speeds speeds =
      bearing::speeds(simulation_.info.bearing, now.shaft_speed_rpm, now.slip);
  const double time_s = static_cast<double>(samples) / simulation_.info.sample_rate_hz;
  motion_.cage_angle_rad = turned_by(motion_.cage_angle_rad, speeds.cage * time_s);
  const double defect_speed = defect_.fault_type == Defect::inner    ? speeds.shaft
                              : defect_.fault_type == Defect::roller ? speeds.spin
                                                                     : 0;
  motion_.defect_angle_rad = turned_by(motion_.defect_angle_rad, defect_speed * time_s);
  const double innovation = std::sqrt(1 - correlation_ * correlation_);
  for (double& deviation : deviations_) {
    deviation = correlation_ * deviation + innovation * drift_.normal(0, 1);
  }
  done_ += samples;
}

std::vector<float> Machine::next() {
  const bool healthy = done_ < onset_;
  const bool appears = done_ == onset_;
  const std::size_t most = appears ? 1 : bearing::courses_at_once;
  std::vector<bearing::Course> courses;
  std::vector<std::size_t> lengths;
  while (courses.size() < most && done_ < samples_ && healthy == (done_ < onset_)) {
    courses.push_back(course());
    lengths.push_back(next_length());
    run_on(lengths.back());
  }
  std::vector<float> signal;
  if (courses.empty()) return signal;
  const std::size_t longest = *std::ranges::max_element(lengths);
  const bearing::Sampling sampling{simulation_.info.sample_rate_hz, longest};
  const std::vector<double> rows =
      appears ? bearing::simulate_onset(simulation_.info.bearing, defect_, courses, sampling)
              : bearing::simulate(simulation_.info.bearing,
                                  healthy ? bearing::LocalDefect{} : defect_, courses, sampling);
  for (std::size_t i = 0; i < courses.size(); ++i) {
    for (const double x : std::span(rows).subspan(i * longest, lengths[i])) {
      signal.push_back(static_cast<float>(x + noise_.normal(0, noise_deviation_)));
    }
  }
  return signal;
}

}  // namespace piae::signal
