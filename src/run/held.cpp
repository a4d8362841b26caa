#include "run/held.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "scoring/ratios.hpp"

namespace piae::run {

namespace {

namespace fs = std::filesystem;

/// Returns the methods of the catalogue, in its order, then requested ones that it lacks.
std::vector<std::string> methods_in_order(const Grid& requested) {
  std::vector<std::string> methods;
  const auto add = [&](const std::string& method) {
    if (std::ranges::count(methods, method) == 0) methods.push_back(method);
  };
  for (const augment::CatalogueEntry& entry : augment::catalogue()) add(entry.name);
  for (const Combination& cell : requested.combinations) add(cell.method);
  for (const std::string& method : requested.scored) add(method);
  return methods;
}

bool is_requested(const Grid& requested, const Combination& cell) {
  return std::ranges::count(requested.combinations, cell) > 0;
}

/// Calls f for each possible combination: by classifier, then method, then ratio.
template <class F>
void for_each_combination(const Grid& requested, Classifiers which, const F& f) {
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    const bool is_papers = std::string(classifier.name) == scoring::paper_classifier;
    if (!is_papers && which == Classifiers::papers) continue;
    for (const std::string& method : methods_in_order(requested)) {
      for (const scoring::Ratio& ratio : scoring::all_ratios()) {
        if (go_together(method, ratio)) f(Combination{method, ratio.name, classifier.name});
      }
    }
  }
}

/// Selects if the test windows (A) of the seeds are read, too, if they exist.
enum class Tested { read, left };

/// Collects cells with one file name over the seeds, the requested and the held ones, and then
/// reads them all.
class CellsOfSeeds {
 public:
  CellsOfSeeds(const Layout& layout, const Grid& requested, const Held& held, Tested tested,
               Collected& into, const SeenCell& seen = {})
      : layout_(layout),
        requested_(requested),
        held_(held),
        tested_(tested),
        into_(into),
        seen_(seen) {}

  void diagnoses(const Combination& cell) {
    const auto file_of = [&](std::int64_t seed) {
      return layout_.diagnosis(cell.method, cell.ratio, seed, cell.classifier);
    };
    const auto seeds = chosen(is_requested(requested_, cell), cell, file_of);
    if (seeds.empty()) return;
    into_.grid.combinations.push_back(cell);
    diagnoses_.push_back({series_of(cell), seeds});
  }

  void scores(const std::string& method) {
    const auto file_of = [&](std::int64_t seed) { return layout_.score(method, seed); };
    const bool needed = std::ranges::count(requested_.scored, method) > 0;
    const auto seeds = chosen(needed, {method, ""}, file_of);
    if (seeds.empty()) return;
    into_.grid.scored.push_back(method);
    scores_.push_back({method, seeds});
  }

  void read() {
    if (tested_ == Tested::read) read_tested_windows();
    collect_diagnoses(layout_, requested_.dataset, diagnoses_, into_.results, windows_, seen_);
    collect_scores(layout_, requested_.dataset, scores_, into_.results, seen_);
  }

 private:
  template <class FileOf>
  std::vector<std::int64_t> chosen(bool needed, const Combination& cell, const FileOf& file_of) {
    auto seeds = held_.seeds_with(needed ? requested_.seeds : std::vector<std::int64_t>{}, file_of);
    for (const std::int64_t seed : held_.seeds()) {
      if (held_.leaves_out(file_of(seed))) {
        into_.results.left_out.push_back({cell.method, cell.ratio, seed, cell.classifier});
      }
    }
    seeds_.insert(seeds.begin(), seeds.end());
    into_.grid.seeds.assign(seeds_.begin(), seeds_.end());
    return seeds;
  }

  void read_tested_windows() {
    std::vector<std::int64_t> there;
    std::ranges::copy_if(seeds_, std::back_inserter(there),
                         [&](std::int64_t seed) { return held_.has(layout_.windows("A", seed)); });
    collect_tested_windows(layout_, requested_.dataset, there, windows_, into_.results);
  }

  const Layout& layout_;
  const Grid& requested_;
  const Held& held_;
  Tested tested_;
  Collected& into_;
  SeenCell seen_;
  TestedWindowsBySeed windows_;
  std::set<std::int64_t> seeds_;
  std::vector<SeriesOfSeeds> diagnoses_;
  std::vector<MethodOfSeeds> scores_;
};

void add_diagnoses(const Grid& requested, Classifiers which, CellsOfSeeds& cells) {
  for_each_combination(requested, which, [&](const Combination& cell) { cells.diagnoses(cell); });
}

void add_scores(const Grid& requested, CellsOfSeeds& cells) {
  for (const std::string& method : methods_in_order(requested)) {
    if (has_score(method)) cells.scores(method);
  }
}

}  // namespace

Held::Held(const Layout& layout, const std::vector<std::string>& leave_out)
    : folders_{layout.folder()},
      seeds_(layout.seeds()),
      left_out_(leave_out.begin(), leave_out.end()) {}

Held::Held(const Layout& layout, const Layout& other, const std::vector<std::string>& leave_out)
    : Held(layout, leave_out) {
  folders_.push_back(other.folder());
}

bool Held::exists(const fs::path& file) const {
  const fs::path name = file.lexically_relative(folders_.front());
  return std::ranges::all_of(
      folders_, [&](const fs::path& folder) { return fs::is_regular_file(folder / name); });
}

bool Held::has(const fs::path& file) const { return exists(file) && !leaves_out(file); }

bool Held::leaves_out(const fs::path& file) const {
  const fs::path name = file.lexically_relative(folders_.front());
  const auto holds = [&](const fs::path& path) {
    return std::mismatch(path.begin(), path.end(), name.begin(), name.end()).first == path.end();
  };
  return std::ranges::any_of(left_out_, holds) && exists(file);
}

std::vector<std::int64_t> Held::seeds_with(
    const std::vector<std::int64_t>& requested,
    const std::function<fs::path(std::int64_t)>& file_of) const {
  std::set<std::int64_t> chosen;
  for (const std::int64_t seed : requested) {
    if (!leaves_out(file_of(seed))) chosen.insert(seed);
  }
  for (const std::int64_t seed : seeds_) {
    if (has(file_of(seed))) chosen.insert(seed);
  }
  return {chosen.begin(), chosen.end()};
}

void bind_leave_out(const cli::Options& command, std::vector<std::string>& leave_out) {
  command.add("--leave-out", leave_out,
              "Stale files and folders of the dataset, such as "
              "seed1/smote; tables and figures leave them out");
}

Grid held_grid(const Layout& layout, const Grid& requested, const Held& held) {
  Grid grid{.dataset = requested.dataset, .scored = {}, .combinations = {}, .seeds = {}};
  std::set<std::int64_t> all;
  const auto any_seed = [&](bool needed, const auto& file_of) {
    const auto seeds =
        held.seeds_with(needed ? requested.seeds : std::vector<std::int64_t>{}, file_of);
    all.insert(seeds.begin(), seeds.end());
    return !seeds.empty();
  };
  for_each_combination(requested, Classifiers::all, [&](const Combination& cell) {
    const auto file_of = [&](std::int64_t seed) {
      return layout.diagnosis(cell.method, cell.ratio, seed, cell.classifier);
    };
    if (any_seed(is_requested(requested, cell), file_of)) grid.combinations.push_back(cell);
  });
  for (const std::string& method : methods_in_order(requested)) {
    const bool needed = std::ranges::count(requested.scored, method) > 0;
    const bool there = has_score(method) && any_seed(needed, [&](std::int64_t seed) {
                         return layout.score(method, seed);
                       });
    if (there) grid.scored.push_back(method);
  }
  grid.seeds.assign(all.begin(), all.end());
  return grid;
}

Collected collect_held_diagnoses(const Layout& layout, const Grid& requested, const Held& held,
                                 Classifiers which) {
  Collected collected;
  collected.grid.dataset = requested.dataset;
  CellsOfSeeds cells(layout, requested, held, Tested::left, collected);
  add_diagnoses(requested, which, cells);
  cells.read();
  return collected;
}

std::vector<CellName> held_models(const Layout& layout, const Grid& requested, const Held& held) {
  std::vector<CellName> models;
  for (const std::string& method : methods_in_order(requested)) {
    const bool needed =
        std::ranges::count(requested.combinations, method, &Combination::method) > 0;
    const augment::CatalogueEntry* const entry = augment::find_entry(method);
    if (!needed && (entry == nullptr || !entry->infers)) continue;
    const auto seeds =
        held.seeds_with(needed ? requested.seeds : std::vector<std::int64_t>{},
                        [&](std::int64_t seed) { return layout.model(method, seed); });
    for (const std::int64_t seed : seeds) {
      const bool is_requested = needed && std::ranges::count(requested.seeds, seed) > 0;
      if (is_requested || held.has(layout.real_windows(seed))) models.push_back({method, "", seed});
    }
  }
  return models;
}

Results collect_held_scores(const Layout& layout, const Grid& requested, const Held& held) {
  Collected collected;
  CellsOfSeeds cells(layout, requested, held, Tested::left, collected);
  add_scores(requested, cells);
  cells.read();
  return std::move(collected.results);
}

Collected collect_held(const Layout& layout, const Grid& requested, const Held& held,
                       const SeenCell& seen) {
  Collected collected;
  collected.grid.dataset = requested.dataset;
  CellsOfSeeds cells(layout, requested, held, Tested::read, collected, seen);
  add_diagnoses(requested, Classifiers::all, cells);
  add_scores(requested, cells);
  cells.read();
  return collected;
}

}  // namespace piae::run
