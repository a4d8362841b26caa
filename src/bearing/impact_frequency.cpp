#include "bearing/impact_frequency.hpp"

#include <stdexcept>

#include "bearing/kinematics.hpp"

namespace piae::bearing {

double impact_frequency_hz(const Geometry& geometry, Defect fault_type, double shaft_speed_rpm) {
  const FaultFrequencies f = fault_frequencies(geometry, shaft_speed_rpm);
  switch (fault_type) {
    case Defect::outer:
      return f.bpfo_hz;
    case Defect::inner:
      return f.bpfi_hz;
    case Defect::roller:
      return 2 * f.bsf_hz;
    case Defect::none:
    case Defect::other:
      return 0;
  }
  throw std::logic_error("no such defect");
}

double passage_s(const Geometry& geometry, const LocalDefect& defect, double shaft_speed_rpm) {
  const Speeds s = speeds(geometry, shaft_speed_rpm);
  const double angle = 2 * half_angle_rad(geometry, defect);
  switch (defect.fault_type) {
    case Defect::outer:
      return angle / s.cage;
    case Defect::inner:
      return angle / (s.shaft - s.cage);
    case Defect::roller:
      return angle / s.spin;
    case Defect::none:
    case Defect::other:
      return 0;
  }
  throw std::logic_error("no such defect");
}

}  // namespace piae::bearing
