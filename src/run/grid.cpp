#include "run/grid.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"

namespace piae::run {

namespace {

std::int64_t parse_seed(const std::string& word) {
  const std::optional<std::int64_t> seed = number_in<std::int64_t>(word);
  if (!seed || *seed < 0) {
    throw Error(Exit::usage, "--seeds: '" + word + "' is not a seed; seeds are 0, 1, 2, ...");
  }
  return *seed;
}

std::vector<std::string> in_order_of_table_5(const std::vector<std::string>& names) {
  std::vector<std::string> ordered;
  for (const std::string& name : names) scoring::find_ratio(name);
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    if (std::ranges::find(names, ratio.name) != names.end()) ordered.emplace_back(ratio.name);
  }
  return ordered;
}

}  // namespace

void bind(const cli::Options& command, GridOptions& options) {
  command.add("--dataset", options.dataset, "Dataset, such as cwru").required();
  bind_cells(command, options);
}

void bind_cells(const cli::Options& command, GridOptions& options) {
  command.add("--methods", options.methods, "Methods, such as: none piae-dt").required();
  command.add("--ratios", options.ratios, "Ratios, such as: 100to1 10to1 1to1").required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

std::vector<std::string> split_list(const std::string& option,
                                    const std::vector<std::string>& values) {
  constexpr std::string_view separators = ", \t\n";
  std::vector<std::string> words;
  for (const std::string_view value : values) {
    std::size_t first = value.find_first_not_of(separators);
    while (first != std::string_view::npos) {
      const std::size_t end = std::min(value.find_first_of(separators, first), value.size());
      words.emplace_back(value.substr(first, end - first));
      if (std::count(words.begin(), words.end(), words.back()) > 1) {
        throw Error(Exit::usage, option + " names " + words.back() + " twice");
      }
      first = value.find_first_not_of(separators, end);
    }
  }
  if (words.empty()) throw Error(Exit::usage, option + " is empty; name at least one");
  return words;
}

bool go_together(const std::string& method, const scoring::Ratio& ratio) {
  return (method == augment::no_method) == (ratio.generated_per_class == 0);
}

bool has_score(const std::string& method) {
  return method != augment::no_method && !augment::is_ceiling(method);
}

Grid resolve(const GridOptions& options) {
  Grid grid;
  grid.dataset = options.dataset;
  const auto ratios = in_order_of_table_5(split_list("--ratios", options.ratios));
  for (const std::string& word : split_list("--seeds", options.seeds)) {
    grid.seeds.push_back(parse_seed(word));
  }
  std::ranges::sort(grid.seeds);
  const auto twice = std::ranges::adjacent_find(grid.seeds);  // such as 0 and 00
  if (twice != grid.seeds.end()) {
    throw Error(Exit::usage, "--seeds names " + std::to_string(*twice) + " twice");
  }
  for (const std::string& method : split_list("--methods", options.methods)) {
    if (has_score(method)) grid.scored.push_back(method);
    for (const std::string& ratio : ratios) {
      if (go_together(method, scoring::find_ratio(ratio))) {
        grid.combinations.push_back({method, ratio});
      }
    }
  }
  if (grid.combinations.empty()) {
    throw Error(Exit::usage,
                "none of these methods and ratios go together: 'none' exists at 100to1 only, every "
                "other method at every other ratio only");
  }
  return grid;
}

}  // namespace piae::run
