#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/experiment.hpp"

namespace piae::plan {

/// The lists that a request may give.
struct Lists {
  std::vector<std::string> datasets;
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> classifiers;
  std::vector<std::int64_t> seeds;
};

/// The lists that goals have where nothing is given. Throws Error(usage) where a goal needs groups
/// of data sets and pipeline/protocol.toml names none.
Lists default_lists(const Experiment& experiment, const std::vector<std::string>& goals);

/// The methods that the word `paper` stands for.
std::vector<std::string> methods_of_paper();

}  // namespace piae::plan
