#include "figures/feature_maps.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "embedding/trustworthiness.hpp"
#include "embedding/tsne.hpp"

namespace piae::figures {

namespace {

using embedding::Points;
using scoring::DiagnosisRecord;
using scoring::Features;

constexpr double perplexity = 30;
constexpr Eigen::Index neighbours = 12;
constexpr std::size_t fewest_windows = 5;

struct Map {
  Points points;
  double trustworthiness = 0;
  double kl = 0;
};

/// Returns for each method the cell with stored features. If there are several, it is the last one,
/// because ratios are in the order of Table 5, with ever more generated windows.
std::vector<run::Combination> cells_with_features(const Source& source) {
  std::vector<run::Combination> cells;
  const auto is_kept = [&](const run::Combination& cell) {
    return std::filesystem::exists(
        source.layout().features(cell.method, cell.ratio, source.shown_seed()));
  };
  for (const run::Combination& cell : source.grid().combinations) {
    const auto file = source.layout().features(cell.method, cell.ratio, source.shown_seed());
    if (!source.has(cell.method, source.shown_seed(), file)) continue;
    if (cells.empty() || cells.back().method != cell.method) {
      cells.push_back(cell);
    } else if (is_kept(cell) || !is_kept(cells.back())) {
      cells.back() = cell;
    }
  }
  if (cells.empty()) {
    throw Error(Exit::input_missing, "features.h5 is missing for all cells of seed " +
                                         std::to_string(source.shown_seed()) + "; run `make all`");
  }
  return cells;
}

Map map_of(const DiagnosisRecord& record, const std::vector<float> Features::*layer) {
  const std::vector<float>& numbers = (*record.features).*layer;
  const auto windows = static_cast<Eigen::Index>(record.labels.size());
  const Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      features(numbers.data(), windows, static_cast<Eigen::Index>(numbers.size()) / windows);
  const Points points = features.cast<double>();
  const embedding::TsneMap map = embedding::tsne(
      points, {.perplexity = std::min(perplexity, static_cast<double>(windows - 1) / 4)});
  return {.points = map.points,
          .trustworthiness = embedding::trustworthiness(points, map.points,
                                                        std::min(neighbours, (windows - 1) / 2)),
          .kl = map.kl_divergence};
}

void add_map(Numbers& numbers, const DiagnosisRecord& record, const Map& map) {
  numbers.row({record.method, "", "", "", fmt::format("{:.3f}", map.trustworthiness),
               fmt::format("{:.3f}", map.kl)});
  for (const Label label : record.info.labels()) {
    for (std::size_t i = 0; i < record.labels.size(); ++i) {
      if (record.labels[i] != label) continue;
      const auto row = static_cast<Eigen::Index>(i);
      numbers.row({record.method, record.info.class_of(label).name,
                   fmt::format("{:.2f}", map.points(row, 0)),
                   fmt::format("{:.2f}", map.points(row, 1)), "", ""});
    }
  }
}

Numbers maps_of(Source& source, const std::vector<float> Features::*layer) {
  const std::int64_t seed = source.shown_seed();
  std::vector<DiagnosisRecord> records;
  for (const run::Combination& cell : cells_with_features(source)) {
    records.push_back(source.features(cell, seed));
    const std::size_t windows = records.back().labels.size();
    if (windows < fewest_windows) {
      throw Error(Exit::bad_input,
                  source.layout().features(cell.method, cell.ratio, seed).string() + ": has " +
                      std::to_string(windows) + " test windows; a map needs " +
                      std::to_string(fewest_windows) + " or more");
    }
  }
  std::vector<Map> maps(records.size());
  parallel_for(records.size(), [&](std::size_t i) { maps[i] = map_of(records[i], layer); });
  Numbers numbers({"method", "class", "x", "y", "trustworthiness", "kl"});
  for (std::size_t i = 0; i < records.size(); ++i) add_map(numbers, records[i], maps[i]);
  return numbers;
}

}  // namespace

Numbers hidden_map(Source& source) { return maps_of(source, &Features::hidden); }
Numbers output_map(Source& source) { return maps_of(source, &Features::output); }

}  // namespace piae::figures
