#include "bearing/dynamics.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

using Contacts = std::vector<BallContact>;

void require_positive(double value, const std::string& what) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(Exit::bad_input, fmt::format("{} {}; it must be positive and finite", what, value));
}

void require_not_negative(double value, const std::string& what) {
  if (value >= 0 && std::isfinite(value)) return;
  throw Error(Exit::bad_input, fmt::format("{} {}; it must be finite, 0 or more", what, value));
}

void validate(const DynamicsOptions& o) {
  require_positive(o.mass_kg, "mass in kg");
  require_positive(o.stiffness_n_per_m, "stiffness in N/m");
  require_not_negative(o.damping_ns_per_m, "damping in N s/m");
  require_not_negative(o.clearance_um, "clearance in um");
  require_positive(o.load_n, "load in N");
  require_not_negative(o.settling_s, "settling time in s");
  const double lift = o.stiffness_n_per_m * o.clearance_um * 1e-6;
  if (o.load_n > lift) return;
  throw Error(Exit::bad_input,
              fmt::format("load {} N does not close the clearance: stiffness times clearance is {} "
                          "N, and the load must exceed it",
                          o.load_n, lift));
}

/// The sub-steps of eq. 13 over a passage of balls.
class SubSteps {
 public:
  SubSteps(const EquationOfMotion& equation, const BallPassage& passage, double start_s,
           double step_s)
      : equation_(equation), passage_(passage), start_s_(start_s), step_s_(step_s) {
    passage_.at(start_s_, at_end_);
  }

  void advance(State& state) {
    // Ball positions do not depend on the state: each is computed once, the end of one sub-step
    // being the begin of the next.
    std::swap(at_begin_, at_end_);
    const double begin_s = start_s_ + static_cast<double>(done_) * step_s_;
    passage_.at(begin_s + step_s_ / 2, at_middle_);
    ++done_;
    passage_.at(start_s_ + static_cast<double>(done_) * step_s_, at_end_);
    stepper_.do_step(
        [this](const State& s, State& derivative, double since_begin_s) {
          derivative = {s[1], equation_.acceleration(s, contacts(since_begin_s))};
        },
        state, 0.0, step_s_);
  }

 private:
  [[nodiscard]] const Contacts& contacts(double since_begin_s) const {
    if (since_begin_s < 0.25 * step_s_) return at_begin_;
    return since_begin_s < 0.75 * step_s_ ? at_middle_ : at_end_;
  }

  const EquationOfMotion& equation_;
  const BallPassage& passage_;
  double start_s_;
  double step_s_;
  std::size_t done_ = 0;
  Contacts at_begin_;
  Contacts at_middle_;
  Contacts at_end_;
  boost::numeric::odeint::runge_kutta4<State> stepper_;
};

[[noreturn]] void fail_diverged(double time_s, double step_s) {
  throw Error(Exit::failed, fmt::format("eq. 13 diverged at {:.6g} s with sub-steps of {:.3g} s: "
                                        "stiffness and damping over mass ask for shorter ones",
                                        time_s, step_s));
}

}  // namespace

double EquationOfMotion::acceleration(const State& state,
                                      std::span<const BallContact> balls) const {
  double contact = 0;
  for (const BallContact& ball : balls) {
    const double compression = state[0] * ball.along - ball.delta_m;
    if (compression > 0) contact += compression * std::sqrt(compression) * ball.along;
  }
  return (load_n - damping_ns_per_m * state[1] - stiffness_n_per_m * state[0] -
          contact_n_per_m15 * contact) /
         mass_kg;
}

double largest_stiffness_n_per_m(const DynamicsOptions& options) {
  return 0.98 * options.load_n / (options.clearance_um * 1e-6);
}

double static_equilibrium_m(const EquationOfMotion& e, std::span<const BallContact> balls) {
  // The force at rest is convex and growing in s: from above, Newton's method comes down to its
  // root. Without contact the first guess is the root.
  double s = e.load_n / e.stiffness_n_per_m;
  for (int i = 0; i < 50; ++i) {
    double slope = e.stiffness_n_per_m;
    for (const BallContact& ball : balls) {
      const double compression = std::max(s * ball.along - ball.delta_m, 0.0);
      slope += 1.5 * e.contact_n_per_m15 * std::sqrt(compression) * ball.along * ball.along;
    }
    const double change = e.mass_kg * e.acceleration({s, 0}, balls) / slope;
    s += change;
    if (std::abs(change) <= 1e-15 * s) break;
  }
  return s;
}

std::vector<double> integrate(const EquationOfMotion& equation, const BallPassage& passage,
                              State& state, double start_s, const Sampling& sampling,
                              double max_sub_step_s) {
  require_positive(sampling.rate_hz, "sample rate in Hz");
  require_positive(max_sub_step_s, "longest sub-step in s");
  const double interval_s = 1 / sampling.rate_hz;
  const auto steps = static_cast<std::size_t>(std::ceil(interval_s / max_sub_step_s));
  const double step_s = interval_s / static_cast<double>(steps);
  SubSteps sub_steps(equation, passage, start_s, step_s);
  std::vector<double> acceleration(sampling.samples);
  for (std::size_t i = 0; i < sampling.samples; ++i) {
    const double velocity = state[1];
    for (std::size_t step = 0; step < steps; ++step) sub_steps.advance(state);
    acceleration[i] = (state[1] - velocity) * sampling.rate_hz;
    const bool sane = std::isfinite(state[1]) && std::abs(state[0]) < 1;  // 1 m: never a bearing
    if (!sane) {
      fail_diverged(start_s + static_cast<double>(i + 1) * interval_s, step_s);
    }
  }
  return acceleration;
}

std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& o,
                             const Sampling& sampling) {
  validate(o);
  require_positive(sampling.rate_hz, "sample rate in Hz");
  const BallPassage passage(geometry, defect, motion, o.clearance_um * 1e-6);
  const EquationOfMotion equation{o.mass_kg, o.damping_ns_per_m, o.stiffness_n_per_m,
                                  contact_stiffness(geometry, o.hertz), o.load_n};
  const double settling_samples = std::ceil(o.settling_s * sampling.rate_hz);
  const double start_s = -settling_samples / sampling.rate_hz;
  Contacts at_start;
  passage.at(start_s, at_start);
  State state{static_equilibrium_m(equation, at_start), 0};
  const Sampling settling{sampling.rate_hz, static_cast<std::size_t>(settling_samples)};
  integrate(equation, passage, state, start_s, settling, o.max_sub_step_s);
  return integrate(equation, passage, state, 0, sampling, o.max_sub_step_s);
}

}  // namespace piae::bearing
