#pragma once

#include <gtest/gtest.h>

#include <string>

namespace piae {

/// Parts of a description, to be joined in this order.

/// Returns the paper's test bearing (Table 1), and its shaft speed.
inline std::string described_bearing(const std::string& dataset) {
  return "name = \"" + dataset + "\"\n" + R"(sample_rate_hz = 12000
shaft_speed_rpm = 1797
[bearing]
balls = 9
ball_diameter_mm = 7.94
pitch_diameter_mm = 39.0
inner_raceway_mm = 31.06
outer_raceway_mm = 46.94
contact_angle_deg = 0
)";
}

inline const std::string described_normal = R"([[class]]
name = "Normal"
defect = "none"
)";

inline const std::string described_ir007 = R"([[class]]
name = "IR007"
defect = "inner"
defect_size_mm = 0.1778
)";

inline const std::string described_or021 = R"([[class]]
name = "OR021"
defect = "outer"
defect_size_mm = 0.5334
)";

/// Returns a simulation without noise; `described_simulation(...) + "snr_db = 10\n"` adds some.
inline std::string described_simulation(const std::string& records_per_class,
                                        const std::string& record_s) {
  return R"([simulation]
seed = 0
records_per_class = )" +
         records_per_class + "\nrecord_s = " + record_s + R"(
mass_kg = 1.0
stiffness_n_per_m = 1e8
stiffness_spread = 0.1
damping_ns_per_m = 500
damping_spread = 0.2
clearance_um = 2.0
load_n = 1000
slip_max = 0.01
speed_spread = 0.001
)";
}

/// Replaces a text, which must occur, by another.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace piae
