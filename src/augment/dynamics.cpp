#include "augment/dynamics.hpp"

#include <spdlog/fmt/fmt.h>

#include "base/error.hpp"
#include "base/label.hpp"

namespace piae::augment {

namespace {

void require_contact(const signal::SimulationOptions& options) {
  const double lift = bearing::largest_lift_n(options.dynamics, options.variation);
  if (options.dynamics.load_n > lift) return;
  throw Error(
      Exit::usage,
      fmt::format("--load-n {}: must exceed {:.6g} N, the largest stiffness (mean + 3 standard "
                  "deviations) times the clearance; below it, balls never touch the races",
                  options.dynamics.load_n, lift));
}

}  // namespace

void Dynamics::bind(const cli::Options& command) {
  command
      .add("--stiffness-n-per-m", options_.dynamics.stiffness_n_per_m,
           "mean stiffness K of eq. 13, N/m")
      .check(cli::positive_number());
  command
      .add("--stiffness-spread", options_.variation.stiffness_spread,
           "spread of K between windows: standard deviation / mean")
      .check(signal::spread());
  command
      .add("--damping-ns-per-m", options_.dynamics.damping_ns_per_m,
           "mean damping C of eq. 13, N s/m")
      .check(cli::positive_number());
  command
      .add("--damping-spread", options_.variation.damping_spread,
           "spread of C between windows: standard deviation / mean")
      .check(signal::spread());
  signal::bind(command, options_);
}

void Dynamics::train(const signal::WindowSet& known, const Stream& /*stream*/,
                     const Compute& /*compute*/, const nets::Checkpoint& /*checkpoint*/,
                     artefact::Writer& model) {
  require_contact(options_);
  signal::write(model, signal::simulation_like(known, options_));
}

signal::WindowSet Dynamics::generate(const artefact::Reader& model, std::size_t count,
                                     const Stream& stream, const Compute& /*compute*/) {
  const signal::WindowSimulation simulation = signal::read_window_simulation(model);
  try {
    require_contact(simulation.options);
  } catch (const Error& error) {
    model.refuse("/simulation", error.what());
  }
  return signal::simulate_windows(simulation, count, stream, [&](Label /*label*/, Stream& random) {
    return bearing::draw_dynamics(random, simulation.options.dynamics,
                                  simulation.options.variation);
  });
}

}  // namespace piae::augment
