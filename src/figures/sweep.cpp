#include "figures/sweep.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <tuple>

#include "augment/catalogue.hpp"
#include "base/numbers.hpp"
#include "figures/intervals.hpp"
#include "figures/trained_options.hpp"
#include "report/accuracies.hpp"
#include "report/sweep.hpp"
#include "scoring/ratios.hpp"

namespace piae::figures {

namespace {

namespace fs = std::filesystem;

using report::SweepPoint;

/// Content of the folders of a sweep, over the seeds that have one.
struct Tried {
  std::vector<std::int64_t> seeds;
  std::set<std::string> cells;  ///< "sweep/batch-1", below the folder of a seed
};

Tried tried_in(const Source& source) {
  Tried tried;
  for (const std::int64_t seed : source.grid().seeds) {
    const fs::path folder = source.layout().sweep_folder(seed);
    if (!fs::is_directory(folder)) continue;
    tried.seeds.push_back(seed);
    for (const auto& entry : fs::directory_iterator(folder)) {
      tried.cells.insert("sweep/" + entry.path().filename().string());
    }
  }
  if (tried.cells.empty()) throw LeftOut("the sweep is missing; run `make sweep`");
  return tried;
}

bool are_the_same(const std::string& one, const std::string& other) {
  const auto number = number_in<double>(one);
  return one == other || (number && number == number_in<double>(other));
}

/// Returns the setting that names the folder of a model: the model's options hold it, with that
/// value.
SweepPoint point_of(const artefact::Reader& model, const std::string& cell) {
  const std::string name = cell.substr(cell.find('/') + 1);
  for (const auto& [key, node] : options_of_training(model)) {
    const std::string factor(key.str());
    if (!name.starts_with(factor + "-")) continue;
    const std::string value = name.substr(factor.size() + 1);
    if (are_the_same(value, node.value_or<std::string>(""))) {
      return {.factor = factor, .value = value, .centre = false};
    }
  }
  model.refuse("/provenance/options",
               "does not have the setting '" + name + "' of its folder's name");
}

/// Orders factors as in Fig. 19, then others; values ascend, words after numbers.
auto order_of(const SweepPoint& point) {
  constexpr std::array paper{"batch", "depth", "loss-weights", "learning-rate"};
  const auto number = number_in<double>(point.value);
  return std::tuple(std::ranges::find(paper, point.factor) - paper.begin(), point.factor, !number,
                    number.value_or(0), point.value);
}

std::vector<SweepPoint> points_of(const Source& source, const Tried& tried) {
  const toml::table grid =
      options_of_training(source.model(augment::paper_method(), tried.seeds.front()));
  std::vector<SweepPoint> points;
  for (const std::string& cell : tried.cells) {
    const artefact::Reader model(source.layout().model(cell, tried.seeds.front()), "model");
    const SweepPoint point = point_of(model, cell);
    const SweepPoint centre{.factor = point.factor,
                            .value = grid[point.factor].value_or<std::string>(""),
                            .centre = true};
    if (!are_the_same(point.value, centre.value)) points.push_back(point);
    const auto is_centre = [&](const SweepPoint& other) {
      return other.centre && other.factor == centre.factor;
    };
    if (std::ranges::none_of(points, is_centre)) points.push_back(centre);
  }
  std::ranges::sort(points, {}, order_of);
  return points;
}

/// Returns the ratios at which the sweep has started.
std::vector<std::string> ratios_of(const run::Layout& layout, const Tried& tried) {
  std::vector<std::string> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const auto has_ratio = [&](const std::string& cell) {
      return std::ranges::any_of(tried.seeds, [&](std::int64_t seed) {
        return fs::exists(layout.diagnosis(cell, ratio.name, seed));
      });
    };
    if (std::ranges::any_of(tried.cells, has_ratio)) ratios.emplace_back(ratio.name);
  }
  if (ratios.empty()) throw Error(Exit::input_missing, "the sweep has no diagnosis yet");
  return ratios;
}

/// Returns the accuracies at one point and ratio by seed, in percent.
std::vector<double> accuracies_of(const Source& source, const std::vector<std::int64_t>& seeds,
                                  const SweepPoint& point, const std::string& ratio) {
  run::Results results;
  run::collect_diagnoses(source.layout(), source.grid().dataset,
                         {{.series = {.name = point.factor + " " + point.value,
                                      .folder = point.folder(augment::paper_method()),
                                      .combination = {augment::paper_method(), ratio}},
                           .seeds = seeds}},
                         results);
  require_whole(results);
  std::vector<double> percents;
  for (const run::Diagnosis& cell : results.diagnoses) percents.push_back(100 * cell.accuracy);
  return percents;
}

void add_point(Numbers& numbers, const std::vector<std::string>& fields,
               const std::vector<double>& percents, const std::vector<std::int64_t>& seeds) {
  const auto add = [&](const std::string& seed, double accuracy, const std::string& low,
                       const std::string& high) {
    std::vector<std::string> row = fields;
    row.insert(row.end(), {seed, digits(accuracy), low, high});
    numbers.row(row);
  };
  for (std::size_t i = 0; i < percents.size(); ++i) {
    add(std::to_string(seeds[i]), percents[i], "", "");
  }
  const scoring::Summary summary = report::summarise_within(report::percents, percents);
  const std::vector<std::string> interval = shown_interval(summary);
  add("mean", summary.mean, interval[0], interval[1]);
}

}  // namespace

Numbers sweeps(Source& source) {
  const Tried tried = tried_in(source);
  const std::vector<std::string> ratios = ratios_of(source.layout(), tried);
  Numbers numbers(
      {"factor", "place", "value", "centre", "ratio", "seed", "accuracy", "low", "high"});
  std::string factor;
  std::size_t place = 0;
  for (const SweepPoint& point : points_of(source, tried)) {
    place = point.factor == factor ? place + 1 : 1;
    factor = point.factor;
    for (const std::string& ratio : ratios) {
      add_point(numbers,
                {factor, std::to_string(place), shown_value(point.value), point.centre ? "1" : "0",
                 ratio},
                accuracies_of(source, tried.seeds, point, ratio), tried.seeds);
    }
  }
  return numbers;
}

}  // namespace piae::figures
