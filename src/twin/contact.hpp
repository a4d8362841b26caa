#pragma once

#include <cstdint>
#include <vector>

#include "signal/dataset_info.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// The contact of eq. 22 for the windows of one class: at a displacement s of the ring its force is
///     F(s) = K_b [(1 - w) max(s - outside_m, 0)^1.5 + w max(s - inside_m, 0)^1.5],
/// where w says whether a ball is in the defect: 0 no, 1 yes, between them for a part of the time.
struct Contact {
  double outside_m = 0;           ///< delta while no ball is in the defect
  double inside_m = 0;            ///< delta while one is (eq. 11)
  double at_rest = 1;             ///< w of the static equilibrium
  std::vector<double> passing{};  ///< w of each sample; none: `at_rest` throughout
};

/// The contact of a class as it is read, for windows of so many samples.
Contact make_contact(const signal::DatasetInfo& info, const signal::ClassInfo& of_class,
                     std::int64_t samples, const TwinOptions& options);

/// The force in N and its derivative by the displacement in N/m. `outside_m` and `inside_m` are
/// how far the displacement is beyond those of the contact.
struct ContactForce {
  double force_n = 0;
  double stiffness_n_per_m = 0;
};
ContactForce contact_force(double outside_m, double inside_m, double w, double contact_n_per_m15);

}  // namespace piae::twin
