#include "bearing/load_zone.hpp"

#include <algorithm>
#include <cmath>

namespace piae::bearing {

double load_share(double angle_rad, double extent) {
  return std::pow(std::max(0.0, 1 - (1 - std::cos(angle_rad)) / (2 * extent)), 1.5);
}

}  // namespace piae::bearing
