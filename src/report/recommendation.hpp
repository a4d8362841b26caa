#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/paired_rows.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// What must be made before a window can be diagnosed, the least first. Between two methods that
/// are as good, the one that takes less is recommended.
enum class Effort {
  nothing,                  ///< known, or healthy, windows are enough
  windows,                  ///< windows are generated; nothing is trained
  classifier,               ///< the classifier is trained
  windows_and_classifier,   ///< windows are generated, and the classifier is trained
  generator,                ///< the generator is trained, the classifier is not
  generator_and_classifier  ///< both are trained
};
Effort effort_of(const std::string& method, const std::string& classifier);

/// A method with a classifier, at the seeds that all have which it is compared with.
struct Candidate {
  AccuracyRow row;
  Effort effort = Effort::nothing;
  /// Minus the best; empty for the best. Only what takes less is tested, and has p_holm: whether
  /// what takes as much or more is worse, nobody asks.
  std::optional<PairedRow> behind = {};
  scoring::Confusion confusion = {};  ///< of all these seeds
};

/// Which method to take at one number of generated windows.
struct Recommendation {
  std::string dataset;
  std::string ratio;                       ///< the name of that of the generated windows
  std::string ratio_label;                 ///< for people
  bool several_classifiers = false;        ///< whether names need one
  std::size_t compared = 0;                ///< pairs of a method and a classifier
  std::vector<std::string> left_out = {};  ///< pairs that lack seeds which the others have
  std::vector<Candidate> by_effort = {};   ///< the most accurate of each effort, the least first
  std::size_t best = 0;                    ///< the most accurate of all, an index into by_effort
  std::size_t taken = 0;                   ///< the one that is recommended
  bool can_tell = true;                    ///< whether so many seeds can show a difference at all
  std::vector<signal::ClassInfo> classes = {};

  [[nodiscard]] const Candidate& most_accurate() const { return by_effort[best]; }
  [[nodiscard]] const Candidate& recommended() const { return by_effort[taken]; }
  /// How many seeds could tell the best from those that take less; 0 where there are none.
  [[nodiscard]] std::size_t seeds_to_tell() const;
};

/// At each ratio that has generated windows, the most windows last, or at 100to1 where nothing is
/// generated. `none` is a candidate at each of them, a ceiling at none.
///
/// The best has the highest mean over the seeds; of equals, it is the one that takes least. Of each
/// lesser effort the most accurate is compared with it, by Wilcoxon's signed-rank test over the
/// seeds, with Holm's correction for these few comparisons. The first that is not significantly
/// worse is recommended. Where the seeds are too few to show any difference, that is the best.
///
/// `rows` are accuracy_rows() of these results, of any classifiers. Where some cells are missing,
/// the seeds and pairs are those of the largest block without a gap.
std::vector<Recommendation> recommendations(const std::vector<AccuracyRow>& rows,
                                            const run::Results& results);

/// The one of them that is said first: of the most generated windows, as far as it compares at
/// least half as many pairs as any other. Null where there is none.
const Recommendation* main_recommendation(const std::vector<Recommendation>& all);

}  // namespace piae::report
