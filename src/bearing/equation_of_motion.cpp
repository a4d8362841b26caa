#include "bearing/equation_of_motion.hpp"

#include <limits>

namespace piae::bearing {

namespace {

/// Returns the compression of a ball; negative if the ball does not touch.
PerCourse compression_m(PerCourse displacement, const BallContact& ball) {
  return displacement * ball.along - ball.delta_m;
}

/// The change of a state per second: velocity and acceleration.
using Rate = State;

State after(const State& state, const Rate& rate, double time_s) {
  return {state.displacement + time_s * rate.displacement, state.velocity + time_s * rate.velocity};
}

/// One sub-step of the Runge-Kutta method, during which the balls advance twice. The balls'
/// positions do not depend on the state, so the processor computes them while it waits for the
/// square roots of the previous rate.
State stepped(const EquationOfMotion& equation, const PerCourse& inverse_mass, const State& state,
              LoadedBalls& balls, double step_s) {
  const auto rate = [&](const State& at) {
    return Rate{at.velocity, equation.force_n(at, balls.contacts()) * inverse_mass};
  };
  const Rate k1 = rate(state);
  balls.advance();
  const Rate k2 = rate(after(state, k1, step_s / 2));
  const Rate k3 = rate(after(state, k2, step_s / 2));
  balls.advance();
  const Rate k4 = rate(after(state, k3, step_s));
  const Rate sum{
      k1.displacement + 2 * (k2.displacement + k3.displacement) + k4.displacement,
      k1.velocity + 2 * (k2.velocity + k3.velocity) + k4.velocity,
  };
  return after(state, sum, step_s / 6);
}

/// Returns -1 in the lanes of plausible courses (displacement below 1 m, finite velocity), 0 in the
/// others.
Vector<std::int64_t> sane(const State& state) {
  constexpr double largest = std::numeric_limits<double>::max();
  return (state.displacement < 1) & (state.displacement > -1) & (state.velocity <= largest) &
         (state.velocity >= -largest);
}

}  // namespace

PerCourse EquationOfMotion::force_n(const State& state, std::span<const BallContact> balls) const {
  PerCourse contact{};
  for (const BallContact& ball : balls) {
    const PerCourse compression = compression_m(state.displacement, ball);
    // Skip a ball that touches in no course: it would add 0 and cost a slow square root.
    if (!any_positive(compression)) continue;
    contact += compression * positive_root(compression) * ball.along;
  }
  return load_n - damping_ns_per_m * state.velocity - stiffness_n_per_m * state.displacement -
         contact_n_per_m15 * contact;
}

PerCourse static_equilibrium_m(const EquationOfMotion& e, std::span<const BallContact> balls) {
  // The force that carries the load is a convex and increasing function of s, so Newton's method
  // converges to the root from any larger s. The start is the s at which the spring alone would
  // carry the load, which is the root without contact. 50 steps are more than enough. Far
  // above the root, where the balls carry most of the load, each step removes a third of s. Near
  // the root, each step doubles the number of exact digits.
  PerCourse s = e.load_n / e.stiffness_n_per_m;
  for (int i = 0; i < 50; ++i) {
    PerCourse slope = e.stiffness_n_per_m;
    for (const BallContact& ball : balls) {
      slope += 1.5 * e.contact_n_per_m15 * positive_root(compression_m(s, ball)) * ball.along *
               ball.along;
    }
    s += e.force_n({s, PerCourse{}}, balls) / slope;
  }
  return s;
}

Solution solve(const EquationOfMotion& equation, LoadedBalls& balls, State& state, double start_s,
               const Sampling& sampling, const SubSteps& sub_steps) {
  const PerCourse inverse_mass = 1 / equation.mass_kg;
  balls.set_step(sub_steps.step_s / 2);
  Solution solution;
  solution.acceleration.reserve(sampling.samples);
  auto still_sane = Vector<std::int64_t>{} - 1;
  for (std::size_t i = 0; i < sampling.samples; ++i) {
    // Recompute the positions at every sample, because rotations accumulate rounding errors.
    balls.set(start_s + static_cast<double>(i) / sampling.rate_hz);
    const PerCourse velocity = state.velocity;
    for (std::size_t step = 0; step < sub_steps.count; ++step) {
      state = stepped(equation, inverse_mass, state, balls, sub_steps.step_s);
    }
    solution.acceleration.push_back((state.velocity - velocity) * sampling.rate_hz);
    still_sane &= sane(state);
    solution.sane_samples -= still_sane;
  }
  return solution;
}

}  // namespace piae::bearing
