#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/paired_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Work before a window can be diagnosed, the least first. Of two methods that are equally good,
/// the one with less effort is recommended.
enum class Effort {
  nothing,                  ///< known or healthy windows are enough
  windows,                  ///< windows are generated; nothing is trained
  classifier,               ///< the classifier is trained
  windows_and_classifier,   ///< windows are generated, and the classifier is trained
  generator,                ///< the generator is trained, the classifier is not
  generator_and_classifier  ///< both are trained
};
Effort effort_of(const std::string& method, const std::string& classifier);

/// A method with a classifier, at the seeds that all compared candidates have.
struct Candidate {
  AccuracyRow row;
  Effort effort = Effort::nothing;
  /// Difference from the best; empty for the best. Only candidates that take less are tested and
  /// have p_holm: whether a candidate with as much effort or more is worse does not matter.
  std::optional<PairedRow> behind = {};
  scoring::Confusion confusion = {};  ///< summed over these seeds
};

/// Recommended method at one number of generated windows.
struct Recommendation {
  std::string dataset;
  std::string ratio;                       ///< name of the ratio of the generated windows
  std::string ratio_label;                 ///< for people
  bool several_classifiers = false;        ///< whether names need a classifier
  std::size_t compared = 0;                ///< pairs of a method and a classifier
  std::vector<std::string> left_out = {};  ///< pairs that lack seeds which the others have
  std::vector<Candidate> by_effort = {};   ///< the most accurate of each effort, the least first
  std::size_t best = 0;                    ///< the most accurate of all, an index into by_effort
  std::size_t taken = 0;                   ///< index of the recommended candidate
  bool can_decide = true;                  ///< whether the seeds are enough to show a difference
  std::vector<signal::ClassInfo> classes = {};

  [[nodiscard]] const Candidate& most_accurate() const { return by_effort[best]; }
  [[nodiscard]] const Candidate& recommended() const { return by_effort[taken]; }
  /// Returns how many seeds could distinguish the best from candidates that take less; 0 if none
  /// takes less.
  [[nodiscard]] std::size_t seeds_to_decide() const;
};

/// Returns a recommendation at each ratio with generated windows, the most windows last; at 100to1
/// if nothing is generated. `none` is a candidate at each ratio; a ceiling never is.
///
/// The best has the highest mean over the seeds; of equals, the one that takes least. The most
/// accurate candidate of each lesser effort is compared with the best: Wilcoxon's signed-rank test
/// over the seeds, with Holm's correction over these comparisons. The first candidate that is not
/// significantly worse is recommended. If the seeds are too few to show any difference, the best is
/// recommended.
///
/// `rows` are accuracy_rows() of `results`, of any classifiers. If cells are missing, uses the
/// seeds and pairs of the largest block without missing cells.
std::vector<Recommendation> recommendations(const std::vector<AccuracyRow>& rows,
                                            const run::Results& results);

/// Returns the recommendation to print first: the one with the most generated windows that compares
/// at least half as many pairs as any other. Null if there is none.
const Recommendation* main_recommendation(const std::vector<Recommendation>& all);

}  // namespace piae::report
