#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/experiment.hpp"

namespace piae::plan {

/// The lists that a request can give.
struct Lists {
  std::vector<std::string> datasets;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> classifiers;
  std::vector<std::int64_t> seeds;
};

/// Returns the default lists of the goals. Throws Error(usage) if a goal needs groups of data sets
/// and pipeline/protocol.toml defines none.
Lists default_lists(const Experiment& experiment, const std::vector<std::string>& goals);

/// Replaces the methods, ratios and classifiers by those of `make transfer`, which include the
/// strongest rivals (to save time without diffusion and flow, and without classifiers that were
/// chosen for ceilings alone), if faults are known in another condition in all of these data sets.
/// Takes the groups of [transfer] in pipeline/protocol.toml that name one of them, or all groups if
/// a data set is in none. Changes nothing for goals with lists of their own, such as `sweep`, and
/// if the protocol does not define groups.
void take_rivals(const Experiment& experiment, const std::vector<std::string>& goals, Lists& lists);

/// Returns the methods that the word `paper` stands for.
std::vector<std::string> methods_of_paper();

}  // namespace piae::plan
