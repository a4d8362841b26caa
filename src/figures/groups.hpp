#pragma once

#include <string>
#include <vector>

#include "run/grid.hpp"

namespace piae::figures {

/// Methods drawn in the same figure, grouped as in the paper's tables.
enum class Group {
  methods,  ///< methods of Tables 8 and 9: all but the ablations
  models,   ///< the paper's five models (Tables 10 and 11) and the ablations of its outlook
};

/// Returns the methods of a group, in their order. Throws LeftOut if there are none.
std::vector<std::string> methods_among(const std::vector<std::string>& all, Group group);

/// Returns the methods of a group in a grid. Throws LeftOut if there are none.
std::vector<std::string> methods_in(const run::Grid& grid, Group group);

}  // namespace piae::figures
