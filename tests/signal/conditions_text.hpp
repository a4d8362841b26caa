#pragma once

#include <string>

namespace piae::signal {

/// A description without [transfer]: a healthy and an outer class, each recorded at 900 and at 1200
/// rpm, and a healthy record of every condition. The classes start at line 11.
inline const std::string two_speeds = R"(name = "rig"
sample_rate_hz = 8000
shaft_speed_rpm = 900
[bearing]
balls = 8
ball_diameter_mm = 7
pitch_diameter_mm = 33.5
contact_angle_deg = 0

[[class]]
name = "ok"
defect = "none"
[[class]]
name = "cracked"
defect = "outer"
defect_size_mm = 0.5

[[record]]
class = "ok"
condition = "900 rpm"
file = "a.csv"
variable = "1"
sample_rate_hz = 8000
[[record]]
class = "ok"
condition = "1200 rpm"
shaft_speed_rpm = 1200
file = "b.csv"
variable = "1"
sample_rate_hz = 8000
[[record]]
class = "cracked"
condition = "900 rpm"
file = "c.csv"
variable = "1"
sample_rate_hz = 8000
[[record]]
class = "cracked"
condition = "1200 rpm"
shaft_speed_rpm = 1190
file = "d.csv"
variable = "1"
sample_rate_hz = 8000
)";

inline const std::string from_900_to_1200 =
    "[transfer]\nknown = [\"900 rpm\"]\ntest = [\"1200 rpm\"]\n";

}  // namespace piae::signal
