#include "impacts/path.hpp"

#include <algorithm>
#include <cmath>

#include "impacts/ranges.hpp"
#include "impacts/response.hpp"

namespace piae::impacts {

using Eigen::ArrayXd;
using Eigen::Index;

void add_to(cli::StoredOptions& table, EqualiserOptions& o) {
  table.in("/equaliser");
  table.add("equaliser-db", o.spread_db, ranges::spread_db,
            "standard deviation of the gain at a knot of the random transfer path, dB",
            "spread_db");
  table.add("equaliser-knots", o.knots, ranges::knots,
            "knots of the random transfer path from 0 Hz to half the sample rate", "knots");
}

ArrayXd along_knots(std::span<const double> knots, Index bins) {
  ArrayXd values(bins);
  const double knots_per_bin =
      static_cast<double>(knots.size() - 1) / static_cast<double>(bins - 1);
  for (Index i = 0; i < bins; ++i) {
    const double place = static_cast<double>(i) * knots_per_bin;
    const auto below = std::min(static_cast<std::size_t>(place), knots.size() - 2);
    values[i] = std::lerp(knots[below], knots[below + 1], place - static_cast<double>(below));
  }
  return values;
}

ArrayXd draw_gains(Stream& random, Index bins, const EqualiserOptions& options) {
  std::vector<double> knots_db(static_cast<std::size_t>(options.knots));
  for (double& db : knots_db) db = random.normal(0, options.spread_db);
  ArrayXd gains = along_knots(knots_db, bins);
  for (double& gain : gains) gain = std::pow(10, gain / 20);
  return gains;
}

void equalise(std::span<double> window, const ArrayXd& gains) {
  Eigen::Map<Eigen::VectorXd> samples(window.data(), static_cast<Index>(window.size()));
  const double before = samples.norm();
  filter(window, std::vector<std::complex<double>>(gains.begin(), gains.end()));
  const double after = samples.norm();
  if (after > 0) samples *= before / after;
}

}  // namespace piae::impacts
