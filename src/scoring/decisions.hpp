#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/label.hpp"
#include "scoring/accuracy.hpp"

namespace piae::scoring {

/// Where windows were cut.
struct Places {
  std::vector<std::int32_t> record;        ///< [n] which recording
  std::vector<std::int64_t> first_sample;  ///< [n] in that recording
};

/// What the decisions over groups of windows are worth.
struct DecisionRates {
  std::size_t windows = 0;    ///< in a group
  std::size_t decisions = 0;  ///< of all classes
  double accuracy = 0;        ///< share of the decisions that are right, in [0, 1]
  double balanced = 0;        ///< mean over the classes of the share of theirs, in [0, 1]
};

/// Over how many windows tables decide: over one as ever, and over as many as a person would listen
/// to.
inline constexpr std::array<std::size_t, 3> decided_windows{1, 10, 60};

/// Groups of `windows` windows of one record and one class that follow each other: the windows of
/// that record and class in time order, cut from the first on. The rest that fills no group is left
/// out, and so is a record that has fewer. Between windows of a group there may be others that are
/// not among these n. Indices of the windows, by class, then record, then time. `labels` are [n].
/// Throws std::logic_error where the lengths differ, and for groups of no window.
std::vector<std::vector<std::size_t>> consecutive_groups(std::span<const Label> labels,
                                                         const Places& places, std::size_t windows);

/// The class with the largest sum of scores over the windows of a group, of equal ones the first.
/// For scores of 1 for the class that was named and 0 for the others it is the vote. `scores` are
/// row-major [n, classes].
Label decide(std::span<const float> scores, std::size_t classes,
             std::span<const std::size_t> group);

/// The rates at each of decided_windows at which every class among the labels has a decision: a
/// mean over fewer classes would be no number to set beside the others.
std::vector<DecisionRates> decision_rates(std::span<const Label> labels,
                                          std::span<const float> scores, std::size_t classes,
                                          const Places& places);

}  // namespace piae::scoring
