#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "signal/dataset_info.hpp"

namespace piae::impacts {

/// A ball meets the defect: an impact at the first edge, and one of opposite sign at the second.
struct Impact {
  double time_s = 0;    ///< at the first edge
  double strength = 1;  ///< at the first edge
  double lag_s = 0;     ///< from the first edge to the second
  double exit = 0;      ///< strength at the second edge / at the first
};

/// Regularity of successive impacts.
struct ImpactRate {
  double period = 0;  ///< in s or in samples
  double jitter = 0;  ///< standard deviation of the time to the next impact / period
};

/// Throws Error(bad_input) if impacts of a class come more often than every two samples at this
/// shaft speed, because windows cannot show such a rate.
void require_rate(const signal::DatasetInfo& info, Label label, double rpm);

/// Calls `visit` with the time of each impact from `first` until `end`. Deviations accumulate,
/// because balls that slip do not return to their places. `visit` draws before the next period is
/// drawn.
void for_each_impact(Stream& random, const ImpactRate& rate, double first, double end,
                     const std::function<void(double time)>& visit);

/// Returns the largest number of impacts in a frame.
std::size_t most_impacts(const ImpactRate& rate, double frame_s);

/// Returns impacts from a random moment of the first period until the end of a frame. `draw` makes
/// impact i, except its time; without `draw`, each impact has the strength 1 and no second edge.
std::vector<Impact> draw_impacts(
    Stream& random, const ImpactRate& rate, double frame_s,
    const std::function<Impact(std::size_t i)>& draw = [](std::size_t) { return Impact{}; });

/// Returns the times in s of the impacts that lie within a window. `samples` are their positions in
/// the window. Leaves out a time that rounds to the end of the window.
std::vector<double> times_within(std::span<const double> samples, std::size_t length,
                                 double rate_hz);

}  // namespace piae::impacts
