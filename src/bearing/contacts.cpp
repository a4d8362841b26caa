#include "bearing/contacts.hpp"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace piae::bearing {

namespace {

void validate(const Motion& m) {
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

}  // namespace

BallPassage::BallPassage(const Geometry& geometry, const LocalDefect& defect, const Motion& motion,
                         double clearance_m)
    : motion_(motion), kind_(defect.kind), clearance_m_(clearance_m) {
  bearing::validate(geometry);
  bearing::validate(geometry, defect);
  validate(motion);
  speeds_ = speeds(geometry, motion.shaft_speed_rpm, motion.slip);
  half_angle_rad_ = half_angle_rad(geometry, defect);
  clearance_in_defect_m_ = clearance_m + defect_depth_m(geometry, defect.size_mm);
  ball_distance_rad_ = 2 * std::numbers::pi / geometry.balls;
  for (int j = 0; j < geometry.balls; ++j) {
    balls_.push_back({std::cos(j * ball_distance_rad_), std::sin(j * ball_distance_rad_)});
  }
}

void BallPassage::at(double time_s, std::vector<BallContact>& contacts) const {
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

int BallPassage::ball_in_defect(double time_s, double cage_angle_rad) const {
  if (kind_ == Defect::none) return -1;
  if (kind_ == Defect::roller) {
    const double spin = motion_.defect_angle_rad + speeds_.spin * time_s;
    return faces_a_race(spin, half_angle_rad_) ? 0 : -1;
  }
  const double turned = kind_ == Defect::inner ? speeds_.shaft * time_s : 0;
  const double defect = motion_.defect_angle_rad + turned;
  const double nearest = std::rint((defect - cage_angle_rad) / ball_distance_rad_);
  if (!meet(cage_angle_rad + nearest * ball_distance_rad_, defect, half_angle_rad_)) return -1;
  const int balls = static_cast<int>(balls_.size());
  const int ball = static_cast<int>(nearest) % balls;
  return ball < 0 ? ball + balls : ball;
}

}  // namespace piae::bearing
