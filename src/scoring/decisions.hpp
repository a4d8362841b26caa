#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/label.hpp"
#include "scoring/accuracy.hpp"

namespace piae::scoring {

/// Position of each window in the recordings.
struct Places {
  std::vector<std::int32_t> record;        ///< [n] index of the recording
  std::vector<std::int64_t> first_sample;  ///< [n] in that recording
};

/// Rates of the decisions over groups of windows.
struct DecisionRates {
  std::size_t windows = 0;    ///< in a group
  std::size_t decisions = 0;  ///< of all classes
  double accuracy = 0;        ///< share of correct decisions, in [0, 1]
  /// mean over the classes of the share of correct decisions, in [0, 1]
  double balanced = 0;
};

/// Numbers of windows per decision in tables: one, as usual, and as many as a person would check.
inline constexpr std::array<std::size_t, 3> decided_windows{1, 10, 60};

/// Returns groups of `windows` consecutive windows of one record and one class, in order of time,
/// from the first one on. Windows that do not fill a group are left out. Other windows, which are
/// not among these n, may lie between windows of a group. The result holds indices, by class, then
/// record, then time. `labels` are [n]. Throws std::logic_error if the lengths differ, and for
/// groups of no window.
std::vector<std::vector<std::size_t>> consecutive_groups(std::span<const Label> labels,
                                                         const Places& places, std::size_t windows);

/// Returns the class with the largest sum of scores over the windows of a group, among equal sums
/// the first. With scores of 1 for the predicted class and 0 for the others it is the majority
/// vote. `scores` are row-major [n, classes].
Label decide(std::span<const float> scores, std::size_t classes,
             std::span<const std::size_t> group);

/// Returns the rates for each of decided_windows for which every class among the labels has a
/// decision. A mean over fewer classes would not be comparable.
std::vector<DecisionRates> decision_rates(std::span<const Label> labels,
                                          std::span<const float> scores, std::size_t classes,
                                          const Places& places);

}  // namespace piae::scoring
