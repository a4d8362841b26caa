#pragma once

#include <string>
#include <vector>

#include "run/grid.hpp"

namespace piae::figures {

/// Methods that are drawn in the same figure, as the paper's tables have them side by side.
enum class Group {
  methods,  ///< those that Tables 8 and 9 compare: all but the ablations
  models,   ///< the paper's five models (Tables 10 and 11), and the ablations of its outlook
};

/// Those of them that are of a group, in their order. Throws LeftOut where none is.
std::vector<std::string> methods_among(const std::vector<std::string>& all, Group group);

/// The same of all methods of a grid.
std::vector<std::string> methods_in(const run::Grid& grid, Group group);

}  // namespace piae::figures
