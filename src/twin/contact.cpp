#include "twin/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bearing/defect.hpp"
#include "bearing/kinematics.hpp"

namespace piae::twin {

namespace {

using bearing::Defect;
using std::numbers::pi;

/// Positions of the balls and the defect of a class, from angle 0 at time 0 (eqs 5 to 9).
class Passage {
 public:
  Passage(const signal::DatasetInfo& info, const bearing::LocalDefect& defect)
      : balls_(info.bearing.balls),
        fault_type_(defect.fault_type),
        half_angle_(bearing::half_angle_rad(info.bearing, defect)),
        speeds_(bearing::speeds(info.bearing, info.known_speed_rpm())) {}

  /// Eq. 9: true if a ball is in the defect.
  [[nodiscard]] bool is_on(double time_s) const {
    if (fault_type_ == Defect::roller)
      return bearing::faces_a_race(speeds_.spin * time_s, half_angle_);
    const double defect_rad = fault_type_ == Defect::inner ? speeds_.shaft * time_s : 0;
    for (int j = 0; j < balls_; ++j) {
      const double ball_rad = speeds_.cage * time_s + 2 * pi * j / balls_;
      if (bearing::meet(ball_rad, defect_rad, half_angle_)) return true;
    }
    return false;
  }

  /// Returns the fraction of the time during which a ball is in the defect.
  [[nodiscard]] double share() const {
    return (fault_type_ == Defect::roller ? 2 : balls_) * half_angle_ / pi;
  }

 private:
  int balls_;
  Defect fault_type_;
  double half_angle_;
  bearing::Speeds speeds_;
};

/// Returns, for each sample, the fraction of its time during which a ball is in the defect. A ball
/// crosses a small defect in little more than a sample, so sampling single instants would miss
/// crossings.
std::vector<double> shares_of_samples(const Passage& passage, std::int64_t samples,
                                      double sample_rate_hz) {
  constexpr int instants = 32;
  std::vector<double> shares;
  for (std::int64_t i = 0; i < samples; ++i) {
    int on = 0;
    for (int j = 0; j < instants; ++j) {
      const double at = static_cast<double>(i) - 0.5 + (j + 0.5) / instants;
      if (passage.is_on(at / sample_rate_hz)) ++on;
    }
    shares.push_back(static_cast<double>(on) / instants);
  }
  return shares;
}

}  // namespace

Contact make_contact(const signal::DatasetInfo& info, const signal::ClassInfo& of_class,
                     std::int64_t samples, const TwinOptions& options) {
  const double clearance_m = options.clearance_um * 1e-6;
  const double depth_m = bearing::defect_depth_m(info.bearing, of_class.defect_size_mm);
  if (options.contact == ContactInterpretation::defect_alone) {
    return {.outside_m = 0, .inside_m = depth_m};
  }
  Contact contact{.outside_m = clearance_m, .inside_m = clearance_m + depth_m};
  if (options.contact == ContactInterpretation::standing) return contact;
  contact.at_rest = 0;
  if (of_class.defect == Defect::none) return contact;
  const Passage passage(info, {.fault_type = of_class.defect, .size_mm = of_class.defect_size_mm});
  if (options.contact == ContactInterpretation::expected) {
    contact.at_rest = passage.share();
  } else {
    contact.passing = shares_of_samples(passage, samples, info.sample_rate_hz);
  }
  return contact;
}

ContactForce contact_force(double outside_m, double inside_m, double w, double contact_n_per_m15) {
  const double outside = std::max(outside_m, 0.0);
  const double inside = std::max(inside_m, 0.0);
  const double root_outside = std::sqrt(outside);
  const double root_inside = std::sqrt(inside);
  return {
      .force_n = (1 - w) * (contact_n_per_m15 * outside * root_outside) +
                 w * (contact_n_per_m15 * inside * root_inside),
      .stiffness_n_per_m = 1.5 * contact_n_per_m15 * ((1 - w) * root_outside + w * root_inside)};
}

}  // namespace piae::twin
