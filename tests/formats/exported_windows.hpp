#pragma once

#include "formats/exported.hpp"

namespace piae::formats {

/// Returns four generated windows of two samples, two of each fault class, with all facts that
/// windows may have. A third class is healthy.
inline signal::WindowSet four_windows() {
  signal::WindowSet windows;
  windows.info.name = "rig";
  windows.info.sample_rate_hz = 12000;
  windows.info.shaft_speed_rpm = 1797;
  windows.info.unit_m_per_s2 = 9.80665;
  windows.info.classes = {{.name = "healthy"},
                          {.name = "IR", .defect = signal::Defect::inner, .defect_size_mm = 0.25},
                          {.name = "OR", .defect = signal::Defect::outer, .defect_size_mm = 0.5}};
  windows.info.conditions = {{.name = "900 rpm", .shaft_speed_rpm = 900}};
  windows.length = 2;
  windows.samples = {0.1F, -2, 3e-20F, 4, 16777216, -0.0F, 1.0F / 3, 100000};
  windows.labels = {1, 1, 2, 2};
  windows.parameters = {{1e8, 500}, {1.5e8, 0.1}, {2e8, 1}, {0, 2}};
  windows.condition = {0, signal::every_condition, 0, 0};
  windows.shaft_speed_rpm = {900, 901.5, 900, 900};
  windows.start_angle_rad = {0, 1.5, 6.25, 3};
  windows.parents = {{0, 3}, {1}, {}, {12}};
  windows.impact_times_s = {{0, 1e-05}, {}, {0.0025}, {0.00015}};
  return windows;
}

inline Exported exported_windows() {
  Exported exported = select(four_windows(), {}, 0);
  exported.role = "E";
  exported.method = "smote";
  return exported;
}

}  // namespace piae::formats
