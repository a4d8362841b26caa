#include "support/reference_dynamics.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

namespace piae::bearing::reference {

namespace {

struct Contact {
  double along = 0;
  double delta_m = 0;
};

/// Determines which balls can carry load at a given time.
class BallPassage {
 public:
  BallPassage(const Geometry& geometry, const LocalDefect& defect, const Motion& motion,
              double clearance_m)
      : motion_(motion),
        speeds_(speeds(geometry, motion.shaft_speed_rpm, motion.slip)),
        fault_type_(defect.fault_type),
        half_angle_rad_(half_angle_rad(geometry, defect)),
        clearance_m_(clearance_m),
        clearance_in_defect_m_(clearance_m + defect_depth_m(geometry, defect.size_mm)),
        ball_distance_rad_(2 * std::numbers::pi / geometry.balls) {
    for (int j = 0; j < geometry.balls; ++j) {
      balls_.push_back({std::cos(j * ball_distance_rad_), std::sin(j * ball_distance_rad_)});
    }
  }

  void at(double time_s, std::vector<Contact>& contacts) const {
    const double cage = motion_.cage_angle_rad + speeds_.cage * time_s;
    const int in_defect = ball_in_defect(time_s, cage);
    const double cosine = std::cos(cage);
    const double sine = std::sin(cage);
    contacts.clear();
    for (std::size_t j = 0; j < balls_.size(); ++j) {
      const double along = cosine * balls_[j].cosine - sine * balls_[j].sine;
      if (along <= 0) continue;
      const bool sinks = static_cast<int>(j) == in_defect;
      contacts.push_back({along, sinks ? clearance_in_defect_m_ : clearance_m_});
    }
  }

 private:
  struct Ball {
    double cosine;
    double sine;
  };

  /// Returns the index of the ball that is in the defect, -1 for none.
  [[nodiscard]] int ball_in_defect(double time_s, double cage_angle_rad) const {
    if (fault_type_ == Defect::none) return -1;
    if (fault_type_ == Defect::roller) {
      const double spin = motion_.defect_angle_rad + speeds_.spin * time_s;
      return faces_a_race(spin, half_angle_rad_) ? 0 : -1;
    }
    const double rotated = fault_type_ == Defect::inner ? speeds_.shaft * time_s : 0;
    const double defect = motion_.defect_angle_rad + rotated;
    const double nearest = std::rint((defect - cage_angle_rad) / ball_distance_rad_);
    if (!meet(cage_angle_rad + nearest * ball_distance_rad_, defect, half_angle_rad_)) return -1;
    const int balls = static_cast<int>(balls_.size());
    const int ball = static_cast<int>(nearest) % balls;
    return ball < 0 ? ball + balls : ball;
  }

  Motion motion_;
  Speeds speeds_;
  Defect fault_type_;
  double half_angle_rad_;
  double clearance_m_;
  double clearance_in_defect_m_;
  double ball_distance_rad_;
  std::vector<Ball> balls_;  // relative to the first one
};

using State = std::array<double, 2>;  // m and m/s

struct Equation {
  DynamicsOptions options;
  double contact_n_per_m15 = 0;

  [[nodiscard]] double acceleration(const State& state, const std::vector<Contact>& balls) const {
    double contact = 0;
    for (const Contact& ball : balls) {
      const double compression = state[0] * ball.along - ball.delta_m;
      if (compression > 0) contact += compression * std::sqrt(compression) * ball.along;
    }
    return (options.load_n - options.damping_ns_per_m * state[1] -
            options.stiffness_n_per_m * state[0] - contact_n_per_m15 * contact) /
           options.mass_kg;
  }

  [[nodiscard]] double static_equilibrium_m(const std::vector<Contact>& balls) const {
    double s = options.load_n / options.stiffness_n_per_m;
    for (int i = 0; i < 50; ++i) {
      double slope = options.stiffness_n_per_m;
      for (const Contact& ball : balls) {
        const double compression = std::max(s * ball.along - ball.delta_m, 0.0);
        slope += 1.5 * contact_n_per_m15 * std::sqrt(compression) * ball.along * ball.along;
      }
      s += options.mass_kg * acceleration({s, 0}, balls) / slope;
    }
    return s;
  }
};

/// Sub-steps of eq. 13 over a passage of balls.
class SubSteps {
 public:
  SubSteps(const Equation& equation, const BallPassage& passage, double start_s, double step_s)
      : equation_(equation), passage_(passage), start_s_(start_s), step_s_(step_s) {
    passage_.at(start_s_, at_end_);
  }

  void advance(State& state) {
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
  [[nodiscard]] const std::vector<Contact>& contacts(double since_begin_s) const {
    if (since_begin_s < 0.25 * step_s_) return at_begin_;
    return since_begin_s < 0.75 * step_s_ ? at_middle_ : at_end_;
  }

  const Equation& equation_;
  const BallPassage& passage_;
  double start_s_;
  double step_s_;
  std::size_t done_ = 0;
  std::vector<Contact> at_begin_;
  std::vector<Contact> at_middle_;
  std::vector<Contact> at_end_;
  boost::numeric::odeint::runge_kutta4<State> stepper_;
};

}  // namespace

std::vector<double> simulate(const Geometry& geometry, const LocalDefect& defect,
                             const Motion& motion, const DynamicsOptions& options,
                             const Sampling& sampling) {
  const BallPassage passage(geometry, defect, motion, options.clearance_um * 1e-6);
  const Equation equation{options, contact_stiffness(geometry, options.hertz)};
  const auto settling = static_cast<std::int64_t>(std::ceil(options.settling_s * sampling.rate_hz));
  const double start_s = -static_cast<double>(settling) / sampling.rate_hz;
  std::vector<Contact> at_start;
  passage.at(start_s, at_start);
  State state{equation.static_equilibrium_m(at_start), 0};
  const double interval_s = 1 / sampling.rate_hz;
  const auto steps = static_cast<int>(std::ceil(interval_s / options.max_sub_step_s));
  SubSteps sub_steps(equation, passage, start_s, interval_s / steps);
  std::vector<double> acceleration;
  for (std::int64_t i = -settling; i < static_cast<std::int64_t>(sampling.samples); ++i) {
    const double velocity = state[1];
    for (int step = 0; step < steps; ++step) sub_steps.advance(state);
    if (i >= 0) acceleration.push_back((state[1] - velocity) * sampling.rate_hz);
  }
  return acceleration;
}

}  // namespace piae::bearing::reference
