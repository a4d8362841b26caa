#include "signal/window_simulation.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "bearing/kinematics.hpp"
#include "signal/amplitude.hpp"
#include "signal/ranges.hpp"

namespace piae::signal {

namespace {

const std::string simulation_group = "/simulation";
/// Most ball steps for one window of each class. The paper's data sets need 5 million; a core does
/// 10 to 50 million per second.
constexpr double most_ball_steps = 1e8;

/// A stored number of the options: its name in the artefact, its member and its permitted values.
template <class Part>
using Stored = std::tuple<const char*, double Part::*, Range>;

constexpr std::array<Stored<bearing::DynamicsOptions>, 5> stored_dynamics{{
    {"mass_kg", &bearing::DynamicsOptions::mass_kg, ranges::mass_kg},
    {"stiffness_n_per_m", &bearing::DynamicsOptions::stiffness_n_per_m,
     ranges::nominal_stiffness_n_per_m},
    {"damping_ns_per_m", &bearing::DynamicsOptions::damping_ns_per_m,
     ranges::nominal_damping_ns_per_m},
    {"clearance_um", &bearing::DynamicsOptions::clearance_um, ranges::clearance_um},
    {"load_n", &bearing::DynamicsOptions::load_n, ranges::load_n},
}};

constexpr std::array<Stored<bearing::Variation>, 4> stored_variation{{
    {"stiffness_spread", &bearing::Variation::stiffness_spread, ranges::spread},
    {"damping_spread", &bearing::Variation::damping_spread, ranges::spread},
    {"speed_spread", &bearing::Variation::speed_spread, ranges::spread},
    {"slip_max", &bearing::Variation::slip_max, ranges::slip},
}};

/// Parameters of eq. 13 for one window.
struct WindowDraw {
  Label label = 0;
  std::int32_t condition = every_condition;
  bearing::DynamicsOptions dynamics;
  bearing::Motion motion;
};

std::vector<WindowDraw> draw_all(const WindowSimulation& simulation, std::size_t count,
                                 const Stream& stream, const DrawDynamics& draw) {
  std::vector<WindowDraw> draws;
  const DatasetInfo& info = simulation.info;
  for (const Label label : info.fault_labels()) {
    const ClassInfo& c = info.class_of(label);
    const Stream own = stream.child(c.name);
    for (std::size_t i = 0; i < count; ++i) {
      Stream random = own.child(std::to_string(i));
      const bearing::DynamicsOptions dynamics = draw(label, random);
      const std::int32_t condition = simulation.conditions[i % simulation.conditions.size()];
      draws.push_back({label, condition, dynamics,
                       bearing::draw_motion(random, c.defect, info.speed_rpm(condition),
                                            simulation.options.variation)});
    }
  }
  return draws;
}

/// Returns the cage angle in the middle of a window modulo the spacing of the balls, in rad.
/// Windows with equal angles have ball contacts at the same times.
double balls_beyond_rad(const WindowSimulation& simulation, const WindowDraw& draw) {
  const bearing::Geometry& geometry = simulation.info.bearing;
  const double middle_s =
      static_cast<double>(simulation.length) / 2 / simulation.info.sample_rate_hz;
  const double turned_rad =
      bearing::speeds(geometry, draw.motion.shaft_speed_rpm, draw.motion.slip).cage * middle_s;
  return std::fmod(draw.motion.cage_angle_rad + turned_rad, 2 * std::numbers::pi / geometry.balls);
}

/// Returns the draws, `count` for each class, in the order that eq. 13 solves fastest. Neighbours
/// within a class have their balls at nearly the same places, so that balls without contact are
/// skipped.
std::vector<const WindowDraw*> in_fast_order(const WindowSimulation& simulation,
                                             std::span<const WindowDraw> draws, std::size_t count) {
  std::vector<std::tuple<std::size_t, std::int32_t, double, const WindowDraw*>> keys;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    keys.emplace_back(i / count, draws[i].condition, balls_beyond_rad(simulation, draws[i]),
                      &draws[i]);
  }
  std::ranges::sort(keys);
  std::vector<const WindowDraw*> order;
  for (const auto& key : keys) order.push_back(std::get<const WindowDraw*>(key));
  return order;
}

/// Returns the windows of draws of one class, row by row, from eq. 13.
std::vector<double> solve(const WindowSimulation& simulation,
                          std::span<const WindowDraw* const> draws) {
  const DatasetInfo& info = simulation.info;
  const ClassInfo& c = info.class_of(draws.front()->label);
  std::vector<bearing::Course> courses;
  for (const WindowDraw* draw : draws) courses.push_back({draw->motion, draw->dynamics});
  try {
    return bearing::simulate(info.bearing, {c.defect, c.defect_size_mm}, courses,
                             {info.sample_rate_hz, simulation.length});
  } catch (const Error& error) {
    throw Error(error.exit(), fmt::format("class {}: {}", c.name, error.what()));
  }
}

/// Returns the signal without its mean, scaled to this RMS.
std::vector<float> scaled(std::span<const double> signal, double rms) {
  const double mean =
      std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
  const double own_rms = rms_of(signal);
  if (!(own_rms > 0)) throw Error(Exit::failed, "eq. 13 gave a window without any vibration");
  const double factor = rms / own_rms;
  std::vector<float> window;
  window.reserve(signal.size());
  for (const double x : signal) window.push_back(static_cast<float>((x - mean) * factor));
  return window;
}

/// Returns the ball steps of eq. 13 for one window of each class with a defect.
double ball_steps(const WindowSimulation& simulation) {
  const DatasetInfo& info = simulation.info;
  const bearing::DynamicsOptions& dynamics = simulation.options.dynamics;
  const double settling = std::ceil(dynamics.settling_s * info.sample_rate_hz);
  const auto steps = bearing::sub_steps(info.sample_rate_hz, dynamics.max_sub_step_s).count;
  return (settling + static_cast<double>(simulation.length)) * static_cast<double>(steps) *
         info.bearing.balls * static_cast<double>(info.fault_labels().size());
}

const std::string too_long =
    "too many classes, balls and seconds of a window to solve eq. 13; choose fewer or shorter "
    "windows";

}  // namespace

void bind(const cli::Options& command, SimulationOptions& options) {
  command.add("--mass-kg", options.dynamics.mass_kg, "mass M of eq. 13, kg")
      .check(cli::positive_number());
  command.add("--load-n", options.dynamics.load_n, "load W of eq. 13, N")
      .check(cli::positive_number());
  command
      .add("--clearance-um", options.dynamics.clearance_um,
           "radial clearance of eq. 11, micrometres; the load must exceed it times the stiffness")
      .check(cli::positive_number());
  command
      .add("--speed-spread", options.variation.speed_spread,
           "spread of the shaft speed between windows: standard deviation / mean")
      .check(spread());
  command
      .add("--slip-max", options.variation.slip_max,
           "largest slip: relative loss of cage and spin speed, uniform from 0 to this")
      .check(cli::share());
}

cli::Check spread() {
  return cli::number("SPREAD", "a number from 0 to below 1/3",
                     [](double x) { return x >= 0 && x < bearing::spread_limit; });
}

WindowSimulation simulation_like(const WindowSet& known, const SimulationOptions& options) {
  WindowSimulation simulation{known.info, known.length, rms_by_class(known), options,
                              known.info.known_conditions()};
  if (ball_steps(simulation) > most_ball_steps) throw Error(Exit::bad_input, too_long);
  return simulation;
}

void write(artefact::Writer& writer, const WindowSimulation& simulation) {
  write(writer, simulation.info);
  writer.attribute("/", "samples", static_cast<std::int64_t>(simulation.length));
  writer.numbers("/classes/rms", simulation.rms);
  writer.group(simulation_group);
  for (const auto& [name, member, range] : stored_dynamics) {
    writer.attribute(simulation_group, name, simulation.options.dynamics.*member);
  }
  for (const auto& [name, member, range] : stored_variation) {
    writer.attribute(simulation_group, name, simulation.options.variation.*member);
  }
}

WindowSimulation read_window_simulation(const artefact::Reader& reader) {
  WindowSimulation simulation;
  simulation.info = read_dataset_info(reader);
  simulation.length =
      static_cast<std::size_t>(reader.integer("/", "samples", ranges::window_samples));
  simulation.rms = read_amplitudes(reader, "/classes/rms", simulation.info);
  simulation.conditions = simulation.info.tested_conditions();
  for (const auto& [name, member, range] : stored_dynamics) {
    simulation.options.dynamics.*member = reader.real(simulation_group, name, range);
  }
  for (const auto& [name, member, range] : stored_variation) {
    simulation.options.variation.*member = reader.real(simulation_group, name, range);
  }
  if (ball_steps(simulation) > most_ball_steps)
    reader.refuse(simulation_group, "cannot be simulated: " + too_long);
  if (simulation.length < 2) {
    reader.refuse("/, attribute samples", "is 1; it must be 2 or more");
  }
  return simulation;
}

WindowSet simulate_windows(const WindowSimulation& simulation, std::size_t count,
                           const Stream& stream, const DrawDynamics& draw) {
  const std::vector<WindowDraw> draws = draw_all(simulation, count, stream, draw);
  WindowSet windows;
  windows.info = simulation.info;
  windows.length = simulation.length;
  windows.samples.resize(draws.size() * simulation.length);
  const std::vector<const WindowDraw*> order = in_fast_order(simulation, draws, count);
  const auto solve_part = [&](std::size_t first, std::size_t part) {
    const std::size_t length = simulation.length;
    const auto some = std::span(order).subspan(first, part);
    const std::vector<double> rows = solve(simulation, some);
    for (std::size_t i = 0; i < part; ++i) {
      const auto window = scaled(std::span(rows).subspan(i * length, length),
                                 simulation.rms[index_of(some[i]->label)]);
      const auto at = (some[i] - draws.data()) * static_cast<std::ptrdiff_t>(length);
      std::ranges::copy(window, windows.samples.begin() + at);
    }
  };
  const std::size_t faulty = simulation.info.fault_labels().size();
  parallel_for_parts(faulty, count, bearing::courses_at_once, solve_part);
  for (const WindowDraw& one : draws) {
    windows.labels.push_back(one.label);
    windows.parameters.push_back({one.dynamics.stiffness_n_per_m, one.dynamics.damping_ns_per_m});
    if (simulation.info.conditions.empty()) continue;
    windows.condition.push_back(one.condition);
    windows.shaft_speed_rpm.push_back(one.motion.shaft_speed_rpm);
  }
  return windows;
}

}  // namespace piae::signal
