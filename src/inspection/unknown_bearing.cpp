#include "inspection/unknown_bearing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace piae::inspection {

namespace {

using signal::BearingLines;

constexpr double lowest_order = 2;
constexpr double highest_order = 16;
// Relative step between candidates. The tenth harmonic of 5 orders moves by 0.03, the width in
// which OrderExcess searches.
constexpr double candidate_step = 0.0006;
constexpr double nothing_db = -std::numeric_limits<double>::infinity();
constexpr int harmonics = 10;
constexpr int cage_harmonics = 8;
constexpr double named_db = 8;
constexpr double certain_db = 18;
constexpr double lowest_inner_order = 4;
constexpr double lead_over_neighbours_db = 2;
constexpr double bearing_tolerance = 0.01;

// Depths of side bands below the line, in dB.
constexpr double inner_depth_db = 7;
constexpr double certain_inner_depth_db = 6;
constexpr double outer_depth_db = 10;
constexpr double certain_outer_depth_db = 12;
constexpr double low_outer_depth_db = 8;  // certain below lowest_inner_order
constexpr double ball_depth_db = 10;
constexpr double certain_ball_depth_db = 8;
constexpr double ball_over_shaft_db = 2;
constexpr double certain_ball_over_shaft_db = 4;

constexpr double lowest_cage = 0.3;
constexpr double highest_cage = 0.46;
constexpr double cage_tolerance = 0.016;

/// Line with the properties that decide its likeness.
struct Line {
  double order = 0;
  double db = 0;        ///< of ten harmonics
  double level_db = 0;  ///< of six harmonics, to compare side bands with
  double shaft_db = 0;  ///< the stronger side bands at 1 and 2 orders
  double cage_db = 0;   ///< the strongest side bands at a cage's order
  double cage_order = 0;
};

/// Highest place of a search.
struct Peak {
  double order = 0;
  double db = nothing_db;
};

/// Returns the first of the highest places low, low + step, ... below `high`.
template <typename Height>
Peak highest_between(double low, double high, double step, const Height& height_db) {
  Peak peak;
  const long places = std::lround(std::ceil((high - low) / step));
  for (long i = 0; i < places; ++i) {
    const double order = low + static_cast<double>(i) * step;
    const double db = height_db(order);
    if (db > peak.db) peak = {order, db};
  }
  return peak;
}

double comb_db(const OrderExcess& excess, double order, int count = harmonics, int step = 1) {
  return excess.comb_db(order, count, step).value_or(nothing_db);
}

/// Returns half the order if its odd harmonics show almost as well, else the order.
double fundamental(const OrderExcess& excess, const Peak& peak) {
  constexpr double reach = 0.003;
  constexpr double least_share = 0.65;
  const double half = peak.order / 2;
  const Peak odd = highest_between(
      half * (1 - reach), half * (1 + reach), half * candidate_step, [&](double order) {
        const bool is_possible = order >= lowest_order && !excess.may_be_foreign(order);
        return is_possible ? comb_db(excess, order, harmonics, 2) : nothing_db;
      });
  return odd.db >= std::max(least_share * peak.db, named_db) ? odd.order : peak.order;
}

Line strongest_line(const OrderExcess& excess) {
  // Steps in the logarithm search each order alike.
  const Peak peak = highest_between(
      std::log(lowest_order), std::log(highest_order), candidate_step, [&](double logarithm) {
        const double order = std::exp(logarithm);
        return excess.may_be_foreign(order) ? nothing_db : comb_db(excess, order);
      });
  Line line;
  line.order = fundamental(excess, {std::exp(peak.order), peak.db});
  line.db = comb_db(excess, line.order);
  line.level_db = excess.side_bands_db(line.order, 0);
  line.shaft_db =
      std::max(excess.side_bands_db(line.order, 1), excess.side_bands_db(line.order, 2));
  constexpr double step = 0.005;
  const Peak cage = highest_between(lowest_cage, highest_cage, step, [&](double distance) {
    return excess.side_bands_db(line.order, distance);
  });
  line.cage_order = cage.order;
  line.cage_db = cage.db;
  return line;
}

/// Returns the order of the cage whose harmonics stand out most. Leaves out a third, which rubbing
/// makes.
Peak strongest_cage(const OrderExcess& excess) {
  constexpr double step = 0.001;
  constexpr double third = 1.0 / 3;
  constexpr double third_reach = 0.008;
  return highest_between(lowest_cage, highest_cage, step, [&](double order) {
    const bool may_rub = std::abs(order - third) <= third_reach;
    return may_rub ? nothing_db : comb_db(excess, order, cage_harmonics);
  });
}

/// Returns the cage's order that 2 BSF = (1 - q^2) / q implies: (1 - q) / 2, with q = d / D.
double cage_of_ball_line(double twice_bsf) {
  const double q = (std::sqrt(twice_bsf * twice_bsf + 4) - twice_bsf) / 2;
  return (1 - q) / 2;
}

/// True if the order is a harmonic of the cage, to 3 % of the cage's order.
bool is_harmonic(double order, double cage) {
  constexpr double reach = 0.03;
  const double ratio = order / cage;
  return std::abs(ratio - std::round(ratio)) < reach;
}

std::optional<double> order_of(const BearingLines& bearing, Likeness likeness) {
  switch (likeness) {
    case Likeness::outer:
      return bearing.bpfo;
    case Likeness::inner:
      return bearing.bpfi;
    case Likeness::ball:
      return bearing.twice_bsf;
    default:
      return std::nullopt;
  }
}

std::vector<std::string> bearings_with(double order, Likeness likeness,
                                       std::span<const BearingLines> known) {
  std::vector<std::string> found;
  for (const BearingLines& bearing : known) {
    const auto line = order_of(bearing, likeness);
    if (line && std::abs(order / *line - 1) < bearing_tolerance)
      found.push_back(bearing.designation);
  }
  return found;
}

/// True if the line leads the combs one and two orders away, so that it is not a side band.
bool leads_its_neighbours(const OrderExcess& excess, const Line& line) {
  constexpr std::array distances{-2, -1, 1, 2};
  return std::ranges::all_of(distances, [&](int distance) {
    return line.db - comb_db(excess, line.order + distance) >= lead_over_neighbours_db;
  });
}

/// Likeness of a line, its order, and whether the side bands leave no doubt.
struct Judgement {
  Likeness likeness = Likeness::nothing;
  double order = 0;
  bool is_clear = false;
};

/// Judges a line as a ball's; empty if it is not.
std::optional<Judgement> ball(const Line& line) {
  const double depth_db = line.level_db - line.cage_db;
  const double over_shaft_db = line.cage_db - line.shaft_db;
  if (depth_db > ball_depth_db || over_shaft_db < ball_over_shaft_db) return std::nullopt;
  const bool is_clear =
      depth_db <= certain_ball_depth_db && over_shaft_db >= certain_ball_over_shaft_db;
  for (const double twice_bsf : {line.order, 2 * line.order}) {
    if (std::abs(line.cage_order - cage_of_ball_line(twice_bsf)) < cage_tolerance) {
      return Judgement{Likeness::ball, twice_bsf, is_clear};
    }
  }
  return std::nullopt;
}

/// Judges a line as one of a race.
Judgement race(const OrderExcess& excess, const Line& line, std::span<const BearingLines> known) {
  const double shaft_depth_db = line.level_db - line.shaft_db;
  const bool is_without_cage = line.level_db - line.cage_db >= certain_outer_depth_db;
  const auto outer = [&](double clear_depth_db) {
    return Judgement{Likeness::outer, line.order,
                     is_without_cage && shaft_depth_db >= clear_depth_db};
  };
  if (line.order < lowest_inner_order) return outer(low_outer_depth_db);
  if (shaft_depth_db > outer_depth_db) return outer(certain_outer_depth_db);
  if (shaft_depth_db > inner_depth_db) return {Likeness::outer_or_inner, line.order};
  const bool is_clear = shaft_depth_db <= certain_inner_depth_db &&
                        leads_its_neighbours(excess, line) &&
                        bearings_with(line.order, Likeness::outer, known).empty();
  return {Likeness::inner, line.order, is_clear};
}

}  // namespace

UnknownLine unknown_line(const OrderExcess& excess, bool speed_is_certain,
                         std::span<const BearingLines> known) {
  const Line line = strongest_line(excess);
  const Peak cage = strongest_cage(excess);
  constexpr double much_stronger_db = 2;
  const bool is_of_cage = line.db < named_db || (is_harmonic(line.order, cage.order) &&
                                                 cage.db >= line.db - much_stronger_db);
  if (cage.db >= named_db && is_of_cage) {
    return {.likeness = Likeness::cage, .order = cage.order, .db = cage.db};
  }
  if (line.db < named_db) return {.db = std::max(line.db, 0.0)};
  const auto of_ball = ball(line);
  const Judgement judged = of_ball ? *of_ball : race(excess, line, known);
  std::vector<std::string> bearings = bearings_with(judged.order, judged.likeness, known);
  const bool is_certain =
      judged.is_clear && line.db >= certain_db && speed_is_certain && !bearings.empty();
  return {.likeness = judged.likeness,
          .order = judged.order,
          .db = line.db,
          .is_certain = is_certain,
          .bearings = std::move(bearings)};
}

}  // namespace piae::inspection
