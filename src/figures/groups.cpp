#include "figures/groups.hpp"

#include <algorithm>

#include "figures/source.hpp"
#include "report/paper.hpp"

namespace piae::figures {

std::vector<std::string> methods_among(const std::vector<std::string>& all, Group group) {
  for (const report::MethodGroup& candidate : report::method_groups(all)) {
    if (candidate.are_models == (group == Group::models)) return candidate.methods;
  }
  throw LeftOut(group == Group::models ? "the run has no ablation of the paper's method"
                                       : "the run has no method of the paper");
}

std::vector<std::string> methods_in(const run::Grid& grid, Group group) {
  std::vector<std::string> all;
  for (const run::Combination& cell : grid.combinations) {
    if (std::ranges::find(all, cell.method) == all.end()) all.push_back(cell.method);
  }
  return methods_among(all, group);
}

}  // namespace piae::figures
