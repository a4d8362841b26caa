#include "run/selection.hpp"

#include <algorithm>

#include "scoring/ratios.hpp"

namespace piae::run {

namespace {

template <class T>
bool among(const std::vector<T>& chosen, const T& each) {
  return chosen.empty() || std::ranges::find(chosen, each) != chosen.end();
}

bool any_generates(const std::vector<std::string>& ratios) {
  return ratios.empty() || std::ranges::any_of(ratios, [](const std::string& name) {
           return scoring::find_ratio(name).generated_per_class > 0;
         });
}

}  // namespace

bool Selection::has_dataset(const std::string& dataset) const { return among(datasets, dataset); }

bool Selection::has(const Combination& cell, std::int64_t seed) const {
  const bool is_score = cell.ratio.empty();
  return among(methods, cell.method) && among(seeds, seed) &&
         (is_score ? any_generates(ratios)
                   : among(ratios, cell.ratio) && among(classifiers, cell.classifier));
}

void bind(const cli::Options& command, Selection& selection) {
  const std::string all = "; default: all";
  command.add("--datasets", selection.datasets, "Data sets to compare, such as: cwru hit-sm" + all);
  command.add("--methods", selection.methods, "Methods, such as: none piae-dt" + all);
  command.add("--ratios", selection.ratios, "Ratios, such as: 100to1 10to1" + all);
  command.add("--seeds", selection.seeds, "Seeds, such as: 0 1" + all);
  bind_classifiers(command, selection.classifiers, "default: all");
}

}  // namespace piae::run
