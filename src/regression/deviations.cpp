#include "regression/deviations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "scoring/distributions.hpp"

namespace piae::regression {

namespace {

constexpr double sigmas = 3;  // allowed standard errors for many seeds
constexpr double last_places =
    4;  // allowed difference of equal numbers, in units in the last place
constexpr double enough_degrees =
    8;  // degrees of freedom at which a quantity uses its own scatter only

/// Identifies a row.
struct Key {
  std::string method;
  std::string classifier;
  std::string ratio;
  std::string quantity;

  bool operator<(const Key& other) const { return order() < other.order(); }
  [[nodiscard]] std::tuple<std::string, std::string, std::string, std::string> order() const {
    return {method, classifier, ratio, quantity};
  }
  /// Returns the kind of a row. Rows of one kind scatter alike: a nearest neighbour scatters less
  /// than a trained network.
  [[nodiscard]] std::pair<std::string, std::string> kind() const { return {quantity, classifier}; }
};

Key key_of(const Measured& each) {
  return {each.method, each.classifier, each.ratio, each.quantity};
}

run::Combination cell_of(const Measured& each) {
  return {each.method, each.ratio, each.classifier};
}

using Seeds = std::map<std::int64_t, double>;
using Series = std::map<Key, Seeds>;

Series series_of(const Measurements& measurements) {
  Series series;
  for (const Measured& each : measurements.values) {
    series[key_of(each)][each.seed] = each.value;
  }
  return series;
}

bool same(double a, double b) {
  const double unit = std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  return std::abs(a - b) <= last_places * unit;
}

/// Scatter of seeds about their mean. The variance is the sum of squares divided by the degrees of
/// freedom, so that groups of seeds can be added.
struct Scatter {
  double squares = 0;
  double degrees = 0;

  void add(const Scatter& other) {
    squares += other.squares;
    degrees += other.degrees;
  }
  [[nodiscard]] double variance() const { return squares / degrees; }
};

Scatter scatter_of(const Seeds& seeds) {
  if (seeds.empty()) return {};
  double mean = 0;
  for (const auto& [seed, value] : seeds) mean += value / static_cast<double>(seeds.size());
  Scatter scatter{0, static_cast<double>(seeds.size()) - 1};
  for (const auto& [seed, value] : seeds) scatter.squares += (value - mean) * (value - mean);
  return scatter;
}

double allowed_standard_errors(double degrees) {
  return scoring::student_t_exceeded_with(scoring::normal_above(sigmas), degrees);
}

/// Run and reference with the scatter of each row and of each kind of rows.
class Sides {
 public:
  Sides(const Measurements& reference, const Measurements& run)
      : reference_(series_of(reference)), run_(series_of(run)) {
    for (const Series* side : {&reference_, &run_}) {
      for (const auto& [key, seeds] : *side) {
        by_row_[key].add(scatter_of(seeds));
        by_kind_[key.kind()].add(scatter_of(seeds));
      }
    }
  }

  /// Returns the row for these seeds, without deciding if it is within the tolerance.
  [[nodiscard]] DeviationRow row(const Key& key, const std::vector<std::int64_t>& seeds) const {
    DeviationRow row;
    row.method = key.method;
    row.classifier = key.classifier;
    row.ratio = key.ratio;
    row.quantity = key.quantity;
    row.seeds = seeds.size();
    const auto n = static_cast<double>(seeds.size());
    for (const std::int64_t seed : seeds) {
      const double a = reference_.at(key).at(seed);
      const double b = run_.at(key).at(seed);
      row.reference += a / n;
      row.run += b / n;
      if (!same(a, b)) ++row.moved_seeds;
    }
    const auto [variance, degrees] = variance_of(key);
    if (degrees > 0) {
      row.standard_error = std::sqrt(variance * 2 / n);
      row.allowed = allowed_standard_errors(degrees);
    }
    return row;
  }

 private:
  struct Variance {
    double value;
    double degrees;
  };
  [[nodiscard]] Variance variance_of(const Key& key) const {
    const Scatter& own = by_row_.at(key);
    const Scatter& all = by_kind_.at(key.kind());
    if (own.degrees >= enough_degrees) return {own.variance(), own.degrees};
    if (all.degrees == 0) return {0, 0};
    const double own_variance = own.degrees > 0 ? own.variance() : 0;
    return {std::max(own_variance, all.variance()), all.degrees};
  }

  Series reference_;
  Series run_;
  std::map<Key, Scatter> by_row_;
  std::map<std::pair<std::string, std::string>, Scatter> by_kind_;
};

bool within(const DeviationRow& row, Tolerance tolerance) {
  if (row.moved_seeds == 0) return true;
  if (tolerance == Tolerance::exact || !row.standard_error) return false;
  return std::abs(row.difference()) <= row.allowed * *row.standard_error;
}

/// Lists the cells of one side that the other side lacks, wholly or in part: a line for each
/// method, ratio and classifier, with the seeds.
std::vector<std::string> cells_without(const Measurements& side, const Measurements& other,
                                       const run::Selection& selection) {
  const Series there = series_of(other);
  std::vector<std::string> names;
  std::map<std::string, std::set<std::int64_t>> cells;
  for (const Measured& each : side.values) {
    if (!selection.has(cell_of(each), each.seed)) continue;
    const auto series = there.find(key_of(each));
    if (series != there.end() && series->second.contains(each.seed)) continue;
    const std::string name = each.ratio.empty()
                                 ? each.method + " score"
                                 : run::name_by(each.method + ' ' + each.ratio, each.classifier);
    if (!cells.contains(name)) names.push_back(name);
    cells[name].insert(each.seed);
  }
  for (std::string& name : names) {
    const std::set<std::int64_t>& seeds = cells.at(name);
    name += seeds.size() == 1 ? ", seed" : ", seeds";
    for (const std::int64_t seed : seeds) name += ' ' + std::to_string(seed);
  }
  return names;
}

}  // namespace

Tolerance tolerance_for(const Measurements& reference, const Measurements& run) {
  const bool one = reference.settings.size() == 1 && reference.settings == run.settings;
  return one ? Tolerance::exact : Tolerance::spread;
}

std::optional<double> DeviationRow::standard_errors() const {
  if (!standard_error) return std::nullopt;
  return difference() == 0 ? 0 : difference() / *standard_error;
}

bool Deviations::acceptable() const {
  return missing.empty() && not_in_reference.empty() &&
         std::ranges::all_of(rows, &DeviationRow::within);
}

Deviations find_deviations(const Measurements& reference, const Measurements& run,
                           const run::Selection& selection, Tolerance tolerance) {
  if (reference.dataset != run.dataset || reference.protocol != run.protocol) {
    throw std::logic_error("run and reference differ in data set or protocol");
  }
  Deviations deviations;
  deviations.missing = cells_without(reference, run, selection);
  deviations.not_in_reference = cells_without(run, reference, selection);

  const Series there = series_of(run);
  std::vector<Key> keys;
  std::map<Key, std::vector<std::int64_t>> seeds;
  for (const Measured& each : reference.values) {
    const Key key = key_of(each);
    const auto series = there.find(key);
    if (!selection.has(cell_of(each), each.seed)) continue;
    if (series == there.end() || !series->second.contains(each.seed)) continue;
    if (!seeds.contains(key)) keys.push_back(key);
    seeds[key].push_back(each.seed);
  }
  const Sides sides(reference, run);
  for (const Key& key : keys) {
    DeviationRow row = sides.row(key, seeds.at(key));
    row.within = within(row, tolerance);
    deviations.rows.push_back(row);
  }
  return deviations;
}

}  // namespace piae::regression
