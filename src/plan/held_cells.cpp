#include "plan/held_cells.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "augment/catalogue.hpp"
#include "base/numbers.hpp"
#include "diagnosis/catalogue.hpp"
#include "plan/words.hpp"
#include "run/layout.hpp"
#include "scoring/ratios.hpp"
#include "settings/points.hpp"

namespace piae::plan {

namespace {

std::optional<std::int64_t> seed_of(const std::string& folder) {
  if (!folder.starts_with("seed")) return std::nullopt;
  const std::string number = folder.substr(4);
  const auto seed = number_in<std::int64_t>(number);
  return seed && *seed >= 0 && std::to_string(*seed) == number ? seed : std::nullopt;
}

std::string with_dash(std::string point) {
  std::ranges::replace(point, '=', '-');
  return point;
}

/// Returns all possible variants by their folders.
std::map<std::string, Variant> variants_of(const Experiment& experiment) {
  std::map<std::string, Variant> variants;
  const auto add = [&](Variant variant) { variants.emplace(variant.folder, variant); };
  for (const augment::CatalogueEntry& entry : augment::catalogue()) add(variant_of(entry.name));
  for (const settings::Sweep& sweep : experiment.sweeps) {
    for (const std::string& point : sweep.points) {
      add({.folder = sweep_folder(sweep.method, point),
           .method = sweep.method,
           .moved = {*settings::parse_point(point)}});
    }
  }
  Words readings = experiment.readings;
  readings.emplace_back("base");
  for (const std::string& reading : readings) {
    add({.folder = reading_folder(reading),
         .method = augment::paper_method(),
         .moved = settings_of_reading(experiment, reading)});
  }
  return variants;
}

bool is_ratio(const std::string& name) {
  return std::ranges::any_of(scoring::all_ratios(),
                             [&](const scoring::Ratio& ratio) { return name == ratio.name; });
}

}  // namespace

std::string sweep_folder(const std::string& method, const std::string& point) {
  return run::sweep_name(method) + '/' + with_dash(point);
}

std::string reading_folder(const std::string& reading) { return "readings/" + with_dash(reading); }

std::vector<settings::Point> settings_of_reading(const Experiment& experiment,
                                                 const std::string& reading) {
  std::vector<settings::Point> points;
  const auto add = [&](const std::string& word) {
    const auto point = settings::parse_point(word);
    const bool is_new =
        point && std::ranges::count(points, point->factor, &settings::Point::factor) == 0;
    if (is_new) points.push_back(*point);
  };
  std::istringstream words(reading);
  if (reading != "base") {
    for (std::string word; std::getline(words, word, '+');) add(word);
  }
  for (const std::string& word : experiment.readings_base) add(word);
  return points;
}

std::vector<HeldCell> held_cells(const Experiment& experiment, const Words& files) {
  using Kind = HeldCell::Kind;
  const std::map<std::string, Variant> variants = variants_of(experiment);
  std::vector<HeldCell> held;
  for (const std::string& file : files) {
    Words parts = fields_of(file, '/');
    const auto seed = parts.size() < 3 ? std::nullopt : seed_of(parts.front());
    if (!seed) continue;
    const bool is_diagnosis = parts.back() == "diagnosis.h5";
    const std::size_t behind = is_diagnosis ? 3 : 1;  // RATIO, CLASSIFIER and the file
    if (parts.size() < 2 + behind) continue;
    std::string folder;
    for (std::size_t i = 1; i + behind < parts.size(); ++i) {
      folder += (folder.empty() ? "" : "/") + parts[i];
    }
    const auto variant = variants.find(folder);
    if (variant == variants.end()) continue;
    if (parts.back() == "model.h5") held.push_back({Kind::model, *seed, variant->second});
    if (parts.back() == "score.h5") held.push_back({Kind::score, *seed, variant->second});
    if (!is_diagnosis) continue;
    const std::string& ratio = parts[parts.size() - 3];
    const std::string& classifier = parts[parts.size() - 2];
    if (is_ratio(ratio) && diagnosis::find_classifier(classifier) != nullptr) {
      held.push_back({Kind::diagnosis, *seed, variant->second, ratio, classifier});
    }
  }
  return held;
}

}  // namespace piae::plan
