#pragma once

#include <cstdint>
#include <vector>

#include "signal/dataset_info.hpp"
#include "twin/options.hpp"

namespace piae::twin {

/// Contact of eq. 22 for the windows of one class. At a displacement s of the ring its force is
///     F(s) = K_b [(1 - w) max(s - outside_m, 0)^1.5 + w max(s - inside_m, 0)^1.5],
/// where w is the fraction of the time during which a ball is in the defect, from 0 to 1.
struct Contact {
  double outside_m = 0;           ///< delta while no ball is in the defect
  double inside_m = 0;            ///< delta while a ball is in the defect (eq. 11)
  double at_rest = 1;             ///< w at the static equilibrium
  std::vector<double> passing{};  ///< w of each sample; if empty, `at_rest` throughout
};

/// Returns the contact of a class by the interpretation `options.contact`, for windows of `samples`
/// samples.
Contact make_contact(const signal::DatasetInfo& info, const signal::ClassInfo& of_class,
                     std::int64_t samples, const TwinOptions& options);

/// Returns the force in N and its derivative by the displacement in N/m. `outside_m` and `inside_m`
/// are the displacement minus the contact's outside_m and inside_m.
struct ContactForce {
  double force_n = 0;
  double stiffness_n_per_m = 0;
};
ContactForce contact_force(double outside_m, double inside_m, double w, double contact_n_per_m15);

}  // namespace piae::twin
