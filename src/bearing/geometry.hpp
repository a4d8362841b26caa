#pragma once

namespace piae::bearing {

/// The geometry of a rolling bearing (paper, Table 1). The defaults are those of the SKF 6205.
struct Geometry {
  int balls = 9;                    ///< n_b
  double ball_diameter_mm = 7.94;   ///< d
  double pitch_diameter_mm = 39.0;  ///< D
  double inner_raceway_mm = 31.06;  ///< D_i
  double outer_raceway_mm = 46.94;  ///< D_o
  double contact_angle_deg = 0.0;   ///< alpha
};

}  // namespace piae::bearing
