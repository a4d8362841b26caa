#include "bearing/loaded_balls.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

using std::numbers::pi;

void validate_motion(const Motion& m) {
  if (!(m.shaft_speed_rpm > 0 && std::isfinite(m.shaft_speed_rpm))) {
    throw Error(Exit::bad_input, fmt::format("shaft speed {} rpm; it must be positive and finite",
                                             m.shaft_speed_rpm));
  }
  if (!(m.slip >= 0 && m.slip < 1)) {
    throw Error(Exit::bad_input, fmt::format("slip {}; it must lie in [0, 1)", m.slip));
  }
  if (!std::isfinite(m.cage_angle_rad) || !std::isfinite(m.defect_angle_rad)) {
    throw Error(Exit::bad_input, "initial angles must be finite");
  }
}

void set_lane_of(Direction& direction, std::size_t lane, double angle_rad) {
  direction.cosine[lane] = std::cos(angle_rad);
  direction.sine[lane] = std::sin(angle_rad);
}

/// Returns a direction rotated by an angle. `by` holds the angle's cosine and sine, as vectors or
/// as one number for all courses.
template <class By>
Direction rotated(const Direction& direction, const By& by) {
  return {direction.cosine * by.cosine - direction.sine * by.sine,
          direction.sine * by.cosine + direction.cosine * by.sine};
}

template <class Mask>
Direction chosen(const Mask& first, const Direction& a, const Direction& b) {
  return {first ? a.cosine : b.cosine, first ? a.sine : b.sine};
}

/// The angular speeds, in rad/s, of the three directions that LoadedBalls follows in a course.
struct Turning {
  double entered = 0;
  double from_defect = 0;
  double facing = 0;
};

Turning turning(Defect fault_type, const Speeds& speeds) {
  switch (fault_type) {
    case Defect::inner:
      return {speeds.cage, speeds.cage - speeds.shaft, 0};
    case Defect::roller:
      return {speeds.cage, 0, 2 * speeds.spin};
    default:
      return {speeds.cage, speeds.cage, 0};
  }
}

}  // namespace

LoadedBalls::LoadedBalls(const Geometry& geometry, const LocalDefect& defect,
                         std::span<const Motion> motions, std::span<const double> clearances_m)
    : fault_type_(defect.fault_type), ball_distance_rad_(2 * pi / geometry.balls) {
  bearing::validate(geometry);
  bearing::validate(geometry, defect);
  std::ranges::for_each(motions, [](const Motion& m) { validate_motion(m); });
  for (int j = 0; 2 * j < geometry.balls; ++j) {
    ahead_.push_back({std::cos(j * ball_distance_rad_), std::sin(j * ball_distance_rad_)});
  }
  contacts_.resize(ahead_.size());
  const double depth_m = defect_depth_m(geometry, defect.size_mm);
  for (std::size_t lane = 0; lane < courses_at_once; ++lane) {
    const std::size_t i = std::min(lane, motions.size() - 1);
    motions_.push_back(motions[i]);
    speeds_.push_back(speeds(geometry, motions[i].shaft_speed_rpm, motions[i].slip));
    clearance_m_[lane] = clearances_m[i];
    clearance_in_defect_m_[lane] = clearances_m[i] + depth_m;
  }
  const double half_angle = half_angle_rad(geometry, defect);
  const bool on_a_ball = fault_type_ == Defect::roller;
  cosine_in_defect_ = std::cos(on_a_ball ? ball_distance_rad_ / 2 : half_angle);
  cosine_facing_race_ = on_a_ball ? std::cos(2 * half_angle) : -2;
}

void LoadedBalls::set(double time_s) {
  for (std::size_t lane = 0; lane < courses_at_once; ++lane) {
    if (lane > 0 && motions_[lane] == motions_[lane - 1]) {
      copy_lane(lane - 1, lane);
    } else {
      set_lane(lane, time_s);
    }
  }
  find_contacts();
}

void LoadedBalls::copy_lane(std::size_t from, std::size_t to) {
  for (Direction* direction : {&entered_, &from_defect_, &facing_}) {
    direction->cosine[to] = direction->cosine[from];
    direction->sine[to] = direction->sine[from];
  }
}

void LoadedBalls::set_lane(std::size_t lane, double time_s) {
  const Motion& motion = motions_[lane];
  const Speeds& speeds = speeds_[lane];
  const double cage = motion.cage_angle_rad + speeds.cage * time_s;
  // The load zone begins at -pi / 2. The ball that entered last is less than one ball spacing past
  // its beginning.
  const double from_begin = cage + pi / 2;
  const double balls_ahead = std::floor(from_begin / ball_distance_rad_);
  const double entered = from_begin - balls_ahead * ball_distance_rad_ - pi / 2;
  set_lane_of(entered_, lane, entered);
  double defect = motion.defect_angle_rad;
  double facing = 0;
  if (fault_type_ == Defect::inner) defect += speeds.shaft * time_s;
  if (fault_type_ == Defect::roller) {
    defect = cage;  // the first ball
    facing = 2 * (motion.defect_angle_rad + speeds.spin * time_s) - pi;
  }
  set_lane_of(from_defect_, lane, entered - defect);
  set_lane_of(facing_, lane, facing);
}

void LoadedBalls::set_step(double step_s) {
  for (std::size_t lane = 0; lane < courses_at_once; ++lane) {
    const Turning speeds = turning(fault_type_, speeds_[lane]);
    if (!(speeds.entered * step_s < ball_distance_rad_)) {
      throw Error(
          Exit::bad_input,
          fmt::format("ball positions every {:.3g} s: balls enter the load zone every {:.3g} "
                      "s; the sub-step must be shorter",
                      step_s, ball_distance_rad_ / speeds.entered));
    }
    set_lane_of(entered_step_, lane, speeds.entered * step_s);
    set_lane_of(from_defect_step_, lane, speeds.from_defect * step_s);
    set_lane_of(facing_step_, lane, speeds.facing * step_s);
  }
}

void LoadedBalls::advance() {
  entered_ = rotated(entered_, entered_step_);
  from_defect_ = rotated(from_defect_, from_defect_step_);
  facing_ = rotated(facing_, facing_step_);
  const Ahead behind{ahead_[1].cosine, -ahead_[1].sine};
  const Direction next = rotated(entered_, behind);
  const auto enters = next.cosine > 0;
  entered_ = chosen(enters, next, entered_);
  from_defect_ = chosen(enters, rotated(from_defect_, behind), from_defect_);
  find_contacts();
}

void LoadedBalls::find_contacts() {
  const PerCourse delta_in_defect_m =
      facing_.cosine > cosine_facing_race_ ? clearance_in_defect_m_ : clearance_m_;
  for (std::size_t j = 0; j < ahead_.size(); ++j) {
    const PerCourse along = rotated(entered_, ahead_[j]).cosine;
    const PerCourse from_defect = rotated(from_defect_, ahead_[j]).cosine;
    contacts_[j].along = along > 0 ? along : PerCourse{};
    contacts_[j].delta_m = from_defect > cosine_in_defect_ ? delta_in_defect_m : clearance_m_;
  }
}

}  // namespace piae::bearing
