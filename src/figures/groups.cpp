#include "figures/groups.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "report/paper_methods.hpp"

namespace piae::figures {

std::vector<std::string> methods_in(const run::Grid& grid, Group group) {
  std::vector<std::string> all;
  for (const run::Combination& cell : grid.combinations) {
    if (std::ranges::find(all, cell.method) == all.end()) all.push_back(cell.method);
  }
  for (const report::MethodGroup& candidate : report::method_groups(all)) {
    if (candidate.are_models == (group == Group::models)) return candidate.methods;
  }
  throw Error(Exit::input_missing, group == Group::models
                                       ? "needs an ablation of the paper's method in the grid"
                                       : "needs a method in the grid");
}

}  // namespace piae::figures
