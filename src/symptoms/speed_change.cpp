#include "symptoms/speed_change.hpp"

#include <algorithm>
#include <cmath>

#include "spectra/bands.hpp"

namespace piae::symptoms {

namespace {

using Eigen::Index;

constexpr double balance_db_per_octave = 2;

/// Interpolates between the levels of two bands; constant beyond the first and the last band.
double level_at(const Eigen::ArrayXd& levels_db, double band) {
  const auto last = static_cast<double>(levels_db.size() - 1);
  const double inside = std::clamp(band, 0.0, last);
  const auto before = std::min(static_cast<Index>(inside), levels_db.size() - 1);
  const Index after = std::min(before + 1, levels_db.size() - 1);
  return std::lerp(levels_db[before], levels_db[after], inside - static_cast<double>(before));
}

}  // namespace

BandPlaces places_of_shape() {
  constexpr double edge = spectra::left_out_edge;
  const double step = (1 - 2 * edge) / static_cast<double>(spectra::spectral_shape_bands);
  return {.first = edge + step / 2, .step = step};
}

BandPlaces places_of_levels() {
  constexpr double any_high_rate_hz = 48000;
  const std::vector<spectra::Band> bands = spectra::narrow_bands(any_high_rate_hz);
  const auto middle = [](const spectra::Band& band) { return (band.low_hz + band.high_hz) / 2; };
  return {.first = middle(bands[0]), .step = middle(bands[1]) - middle(bands[0])};
}

Eigen::ArrayXd change_db(const Eigen::ArrayXd& levels_db, const BandPlaces& places, double ratio) {
  const double balance_db = balance_db_per_octave * std::log2(ratio);
  Eigen::ArrayXd change(levels_db.size());
  for (Index i = 0; i < change.size(); ++i) {
    const double middle = places.first + static_cast<double>(i) * places.step;
    const double of_shaft = level_at(levels_db, (middle / ratio - places.first) / places.step);
    change[i] = std::hypot(of_shaft - levels_db[i], balance_db);
  }
  return change;
}

}  // namespace piae::symptoms
