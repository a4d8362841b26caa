#include "run/grid.hpp"

#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

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

std::vector<std::string> classifiers_of(const GridOptions& options) {
  if (options.classifiers.empty()) return {scoring::paper_classifier};
  std::vector<std::string> names = split_list("--classifiers", options.classifiers);
  for (const std::string& name : names) diagnosis::the_classifier(name);
  return names;
}

/// Adds the cells that the grid does not have yet.
void add_cells(const std::vector<std::string>& methods, const std::vector<std::string>& ratios,
               const std::string& classifier, bool nothing_known, Grid& grid) {
  for (const std::string& method : methods) {
    if (!go_together(method, classifier, nothing_known)) continue;
    for (const std::string& ratio : ratios) {
      const Combination cell{method, ratio, classifier};
      const bool is_new = std::ranges::count(grid.combinations, cell) == 0;
      if (is_new && go_together(method, scoring::find_ratio(ratio))) {
        grid.combinations.push_back(cell);
      }
    }
  }
}

[[noreturn]] void refuse_nothing(bool nothing_known) {
  const std::string of_all =
      "these methods, ratios and classifiers cannot be combined: 'none' exists only at 100to1, "
      "other methods only at other ratios, and rules only for 'none'";
  throw Error(Exit::usage,
              nothing_known ? fmt::format("{}; without known fault windows there are only 'none' "
                                          "by rules and methods that need no known window: {}",
                                          of_all, fmt::join(augment::methods_without_known(), ", "))
                            : of_all);
}

/// Returns the baseline if it is among the methods; else an empty list.
std::vector<std::string> without_generating(std::vector<std::string> methods) {
  std::erase_if(methods, [](const std::string& method) { return method != augment::no_method; });
  return methods;
}

}  // namespace

std::string name_by(const std::string& method, const std::string& classifier) {
  return classifier == scoring::paper_classifier
             ? method
             : method + " by " + diagnosis::marked_name(classifier);
}

void bind(const cli::Options& command, GridOptions& options) {
  command.add("--dataset", options.dataset, "Data set, such as cwru").required();
  bind_cells(command, options);
  bind_nothing_known(command, options.nothing_known);
}

void bind_cells(const cli::Options& command, GridOptions& options) {
  command.add("--methods", options.methods, "Methods, such as: none piae-dt").required();
  command.add("--ratios", options.ratios, "Ratios, such as: 100to1 10to1 1to1").required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

void bind_nothing_known(const cli::Options& command, std::vector<std::string>& nothing_known) {
  command.add("--nothing-known", nothing_known,
              "Data sets without known fault windows (known-per-class = 0): their cells are 'none' "
              "by rules and methods that need no known window");
}

void bind_classifiers(const cli::Options& command, std::vector<std::string>& classifiers,
                      const std::string& otherwise) {
  command.add("--classifiers", classifiers,
              "Classifiers, such as: wdcnn wdcnn-spectrum; " + otherwise);
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

bool go_together(const augment::CatalogueEntry& method, const diagnosis::Classifier& classifier,
                 bool nothing_known) {
  const bool generates = method.kind != augment::Kind::baseline;
  if (classifier.rule) return !generates;
  return !nothing_known || (generates && works_without_known(method));
}

bool go_together(const std::string& method, const std::string& classifier, bool nothing_known) {
  const diagnosis::Classifier& by = diagnosis::the_classifier(classifier);
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry == nullptr ? !nothing_known && !by.rule : go_together(*entry, by, nothing_known);
}

bool has_score(const std::string& method) {
  return method != augment::no_method && !augment::is_ceiling(method);
}

Grid of_classifier(Grid grid, const std::string& classifier) {
  std::erase_if(grid.combinations,
                [&](const Combination& cell) { return cell.classifier != classifier; });
  return grid;
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
  const auto methods = split_list("--methods", options.methods);
  const std::vector<std::string> classifiers = classifiers_of(options);
  const bool nothing_known = std::ranges::count(options.nothing_known, grid.dataset) > 0;
  std::ranges::copy_if(methods, std::back_inserter(grid.scored), [&](const std::string& method) {
    return has_score(method) &&
           std::ranges::any_of(classifiers, [&](const std::string& classifier) {
             return go_together(method, classifier, nothing_known);
           });
  });
  for (const std::string& classifier : classifiers) {
    add_cells(methods, ratios, classifier, nothing_known, grid);
  }
  if (!options.classifiers.empty()) {
    add_cells(without_generating(methods), ratios, diagnosis::reference_classifier, nothing_known,
              grid);
  }
  if (grid.combinations.empty()) refuse_nothing(nothing_known);
  return grid;
}

}  // namespace piae::run
