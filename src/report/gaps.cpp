#include "report/gaps.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "report/labels.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

using SeedSet = std::set<std::int64_t>;
/// Statements, each with the methods that it is about, in order.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Returns "seed 3" or "seeds 0 to 9".
std::string seeds_label(const SeedSet& seeds) {
  return (seeds.size() == 1 ? "seed " : "seeds ") + seed_list({seeds.begin(), seeds.end()});
}

void add_fact(Facts& facts, const std::string& method, const std::string& what) {
  for (auto& [words, methods] : facts) {
    if (words != what) continue;
    methods += ", " + method;
    return;
  }
  facts.emplace_back(what, method);
}

/// Returns "vae, smote: seeds 0 to 2; shift: 10:1".
std::string joined(const Facts& facts) {
  std::string text;
  for (const auto& [words, methods] : facts) {
    text.append(text.empty() ? "" : "; ").append(methods).append(": ").append(words);
  }
  return text;
}

/// Returns the ratios at which this method would have cells if none were missing.
std::vector<std::string> ratios_for(const run::Grid& grid, const std::string& method) {
  std::vector<std::string> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const auto is_there = [&](const run::Combination& cell) { return cell.ratio == ratio.name; };
    if (run::go_together(method, ratio) && std::ranges::any_of(grid.combinations, is_there)) {
      ratios.emplace_back(ratio.name);
    }
  }
  return ratios;
}

std::map<std::string, SeedSet> seeds_by_ratio(const run::Results& results,
                                              const std::string& method,
                                              const std::string& classifier) {
  std::map<std::string, SeedSet> seeds;
  for (const run::Diagnosis& cell : results.diagnoses) {
    if (cell.method == method && cell.classifier == classifier) {
      seeds[cell.ratio].insert(cell.seed);
    }
  }
  return seeds;
}

SeedSet seeds_of_scores(const run::Results& results, const std::string& method) {
  SeedSet seeds;
  for (const scoring::QualityRecord& record : results.qualities) {
    if (record.method == method) seeds.insert(record.seed);
  }
  return seeds;
}

/// Returns the cells that a method has, such as "seeds 0 to 2" or "10:1, 5:1 of seed 0, and 1:1 of
/// seeds 0 to 2"; "" if it has all.
std::string diagnoses_of(const run::Grid& grid, const run::Results& results,
                         const std::string& method, const std::string& classifier) {
  const SeedSet all(grid.seeds.begin(), grid.seeds.end());
  const auto has = seeds_by_ratio(results, method, classifier);
  const std::vector<std::string> ratios = ratios_for(grid, method);
  std::vector<std::pair<SeedSet, std::string>> ratios_by_seeds;
  for (const std::string& ratio : ratios) {
    const auto found = has.find(ratio);
    if (found == has.end()) continue;
    const std::string label = short_ratio_label(ratio);
    const auto same =
        std::ranges::find(ratios_by_seeds, found->second, &std::pair<SeedSet, std::string>::first);
    if (same == ratios_by_seeds.end()) {
      ratios_by_seeds.emplace_back(found->second, label);
    } else {
      same->second += ", " + label;
    }
  }
  const bool at_all_ratios = has.size() == ratios.size();
  if (ratios_by_seeds.size() == 1 && at_all_ratios) {
    const SeedSet& seeds = ratios_by_seeds.front().first;
    return seeds == all ? "" : seeds_label(seeds);
  }
  std::string text;
  for (const auto& [seeds, labels] : ratios_by_seeds) {
    text += (text.empty() ? "" : ", and ") + labels + " of " + seeds_label(seeds);
  }
  return text;
}

std::string fewer_cells(const run::Grid& grid, const run::Results& results) {
  Facts facts;
  std::set<std::string> seen;
  for (const run::Combination& cell : grid.combinations) {
    const std::string name = run::name_by(cell.method, cell.classifier);
    if (!seen.insert(name).second) continue;
    const std::string has = diagnoses_of(run::of_classifier(grid, cell.classifier), results,
                                         cell.method, cell.classifier);
    if (!has.empty()) add_fact(facts, name, has);
  }
  return joined(facts);
}

/// Returns the methods whose scores and diagnoses have different seeds.
std::string fewer_scores(const run::Grid& grid, const run::Results& results) {
  Facts facts;
  for (const std::string& method : grid.scored) {
    SeedSet diagnosed;
    for (const run::Diagnosis& cell : results.diagnoses) {
      if (cell.method == method) diagnosed.insert(cell.seed);
    }
    const SeedSet scored = seeds_of_scores(results, method);
    if (!diagnosed.empty() && scored != diagnosed) add_fact(facts, method, seeds_label(scored));
  }
  return joined(facts);
}

}  // namespace

std::string seed_list(const std::vector<std::int64_t>& seeds) {
  std::string list;
  for (std::size_t first = 0; first < seeds.size();) {
    std::size_t last = first;
    while (last + 1 < seeds.size() && seeds[last + 1] == seeds[last] + 1) ++last;
    list += (first > 0 ? ", " : "") + std::to_string(seeds[first]);
    if (last > first) list += (last > first + 1 ? " to " : ", ") + std::to_string(seeds[last]);
    first = last + 1;
  }
  return list;
}

std::string left_out_line(const run::Results& results) {
  std::map<std::string, SeedSet> seeds;
  std::vector<std::string> methods;
  for (const run::CellName& cell : results.left_out) {
    const std::string name = run::name_by(cell.method, cell.classifier);
    if (seeds[name].empty()) methods.push_back(name);
    seeds[name].insert(cell.seed);
  }
  Facts facts;
  for (const std::string& method : methods) add_fact(facts, method, seeds_label(seeds[method]));
  if (facts.empty()) return "";
  return "left out, because they are damaged or were made with other settings or inputs: cells "
         "of " +
         joined(facts);
}

std::vector<std::string> gap_paragraphs(const run::Grid& grid, const run::Results& results) {
  std::vector<std::string> paragraphs;
  const std::string cells = fewer_cells(grid, results);
  if (!cells.empty()) {
    paragraphs.push_back(
        "Some methods have fewer cells than others; these have only: " + cells +
        ". Each number uses the existing seeds, and a comparison those that both sides have; " +
        mark_of_fewer_seeds + " marks methods with fewer seeds than others of the same table.");
  }
  const std::string scores = fewer_scores(grid, results);
  if (!scores.empty())
    paragraphs.push_back("The quality of windows is known only for " + scores + ".");
  const std::string left_out = left_out_line(results);
  if (!left_out.empty()) {
    paragraphs.push_back("L" + left_out.substr(1) +
                         ". To remake them, give these METHODS and SEEDS.");
  }
  return paragraphs;
}

}  // namespace piae::report
