#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Accuracy of each method with the most generated windows, in percent, its gain over none, in
/// points, and the processor time of its generator for one seed: training and generating, in
/// seconds; and that time for each point gained, if there is a gain. `front` is 1 if no method is
/// at least as accurate in less time. Leaves out ceilings, and methods without a cost; the cheapest
/// comes first. `group` is "paper", "ours" or "control". Columns:
/// method,group,front,ratio,generator_s,accuracy,low,high,gain,s_per_point.
Numbers costs_of_accuracy(Source& source, const report::ClassifierRows& shown);

}  // namespace piae::figures
