#include "report/sweep.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <set>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "scoring/ratios.hpp"

namespace piae::report {

namespace {

SweepPoint parse_point(const std::string& word, const std::vector<std::string>& centre) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == word.size() ||
      word.find('/') != std::string::npos) {
    throw Error(Exit::usage,
                "--points: '" + word + "' is not FACTOR=VALUE; write one such as batch=1");
  }
  return {.factor = word.substr(0, equals),
          .value = word.substr(equals + 1),
          .centre = std::ranges::find(centre, word) != centre.end()};
}

std::filesystem::path diagnosis_of(const run::Layout& layout, const Sweep& sweep,
                                   const SweepPoint& point, const std::string& ratio,
                                   std::int64_t seed) {
  return layout.diagnosis(point.folder(sweep.method), ratio, seed, sweep.classifier);
}

run::Series series_of(const Sweep& sweep, const SweepPoint& point,
                      const run::Combination& combination) {
  run::Series series = run::series_of(combination);
  if (!point.factor.empty()) series.name = point.factor + " " + point.value;
  series.folder = point.folder(sweep.method);
  return series;
}

/// Returns the seeds at which the run holds any changed setting, and the requested seeds. Ignores
/// centres: their cells belong to the grid, which may have other seeds.
std::vector<std::int64_t> swept_seeds(const run::Layout& layout, const Sweep& sweep,
                                      const std::string& ratio, bool is_requested,
                                      const run::Held& held) {
  std::set<std::int64_t> seeds;
  for (const SweepPoint& point : sweep.points) {
    if (point.centre) continue;
    const auto of_point = held.seeds_with(
        is_requested ? sweep.grid.seeds : std::vector<std::int64_t>{},
        [&](std::int64_t seed) { return diagnosis_of(layout, sweep, point, ratio, seed); });
    seeds.insert(of_point.begin(), of_point.end());
  }
  if (is_requested) seeds.insert(sweep.grid.seeds.begin(), sweep.grid.seeds.end());
  return {seeds.begin(), seeds.end()};
}

/// Cells to read at one ratio.
struct SweptRatio {
  run::Combination combination;
  std::vector<std::int64_t> requested;  ///< required seeds
  std::vector<std::int64_t> seeds;      ///< all seeds that may exist
};

std::vector<SweptRatio> swept_ratios(const run::Layout& layout, const Sweep& sweep,
                                     const run::Held& held) {
  std::vector<SweptRatio> ratios;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    const run::Combination cell{sweep.method, ratio.name, sweep.classifier};
    if (!run::go_together(cell.method, ratio)) continue;
    const bool is_requested =
        std::ranges::count(sweep.grid.combinations, cell.ratio, &run::Combination::ratio) > 0;
    SweptRatio swept{.combination = cell,
                     .requested = is_requested ? sweep.grid.seeds : std::vector<std::int64_t>{},
                     .seeds = swept_seeds(layout, sweep, cell.ratio, is_requested, held)};
    if (!swept.seeds.empty()) ratios.push_back(std::move(swept));
  }
  return ratios;
}

std::optional<SweepRow> row_of(const run::Layout& layout, const Sweep& sweep,
                               const SweepPoint& point, const SweptRatio& ratio,
                               const run::Held& held, run::Results& results) {
  const std::string& name = ratio.combination.ratio;
  std::vector<std::int64_t> seeds;
  for (const std::int64_t seed : ratio.seeds) {
    const bool is_requested = std::ranges::count(ratio.requested, seed) > 0;
    if (is_requested || held.has(diagnosis_of(layout, sweep, point, name, seed)))
      seeds.push_back(seed);
  }
  const std::size_t before = results.diagnoses.size();
  run::collect_diagnoses(layout, sweep.grid.dataset,
                         {{series_of(sweep, point, ratio.combination), seeds}}, results);
  const std::vector<run::Diagnosis> cells(
      results.diagnoses.begin() + static_cast<std::ptrdiff_t>(before), results.diagnoses.end());
  if (seeds.empty() || cells.size() < seeds.size()) return std::nullopt;
  return SweepRow{.point = point, .accuracy = accuracy_row(sweep.grid.dataset, cells)};
}

std::vector<std::string> factors_of(const Sweep& sweep) {
  std::vector<std::string> factors;
  for (const SweepPoint& point : sweep.points) {
    if (std::ranges::find(factors, point.factor) == factors.end()) factors.push_back(point.factor);
  }
  return factors;
}

/// Returns a block for each value of the factor, with a row for each ratio.
text::Table factor_table(const std::string& factor, const std::vector<SweepRow>& rows) {
  const auto has_interval = [](const SweepRow& row) {
    return row.accuracy.summary.interval.has_value();
  };
  const bool intervals = std::ranges::any_of(rows, has_interval);
  std::size_t most = 0;
  for (const SweepRow& row : rows) most = std::max(most, row.accuracy.seeds.size());
  std::vector<std::string> header{factor, "", "ratio", "accuracy"};
  if (intervals) header.emplace_back("95 % interval");
  text::Table table(header, 3);
  std::string above;
  for (const SweepRow& row : rows) {
    if (row.point.factor != factor) continue;
    const AccuracyRow& accuracy = row.accuracy;
    const bool first = row.point.value != above;
    std::vector<std::string> cells{
        first ? row.point.value : "", first && row.point.centre ? "as in the grid" : "",
        marked_if(accuracy.seeds.size() < most, ratio_label(accuracy.ratio, accuracy.true_ratio)),
        mean_label(accuracy.summary)};
    if (intervals) cells.push_back(interval_label(accuracy.summary));
    table.row(cells);
    above = row.point.value;
  }
  return table;
}

}  // namespace

std::string SweepPoint::folder(const std::string& method) const {
  return centre ? method : run::sweep_name(method) + "/" + factor + "-" + value;
}

void bind(const cli::Options& command, SweepOptions& options) {
  command.add("--dataset", options.dataset, "Data set, such as cwru").required();
  command.add("--method", options.method, "Method whose settings are moved");
  command.add("--classifier", options.classifier, "Classifier that measures the effect");
  command.add("--points", options.points, "Settings tried, such as: batch=1 batch=5 depth=2")
      .required();
  command.add("--centre", options.centre, "Those of --points that equal the settings of the grid");
  command.add("--ratios", options.ratios, "Ratios, such as: 10to1 1to1").required();
  command.add("--seeds", options.seeds, "Seeds, such as: 0 1 2").required();
}

Sweep resolve(const SweepOptions& options) {
  (void)augment::make_method(options.method);
  Sweep sweep{.method = options.method,
              .classifier = options.classifier,
              .grid = resolve(run::GridOptions{.dataset = options.dataset,
                                               .methods = {options.method},
                                               .ratios = options.ratios,
                                               .seeds = options.seeds,
                                               .classifiers = {options.classifier}}),
              .points = {}};
  const std::vector<std::string> words = run::split_list("--points", options.points);
  std::vector<std::string> centre;
  if (!options.centre.empty()) centre = run::split_list("--centre", options.centre);
  for (const std::string& word : centre) {
    if (std::ranges::find(words, word) == words.end()) {
      throw Error(Exit::usage, "--centre: '" + word + "' is not one of --points");
    }
  }
  if (sweep.method != augment::paper_method()) {
    sweep.points.push_back({.factor = "", .value = "", .centre = true});
  }
  for (const std::string& word : words) sweep.points.push_back(parse_point(word, centre));
  return sweep;
}

std::vector<SweepRow> sweep_rows(const run::Layout& layout, const Sweep& sweep,
                                 const run::Held& held, run::Results& results) {
  const std::vector<SweptRatio> ratios = swept_ratios(layout, sweep, held);
  std::vector<SweepRow> rows;
  for (const SweepPoint& point : sweep.points) {
    for (const SweptRatio& ratio : ratios) {
      if (const auto row = row_of(layout, sweep, point, ratio, held, results)) rows.push_back(*row);
    }
  }
  return rows;
}

std::vector<std::int64_t> seeds_of_any_row(const std::vector<SweepRow>& rows) {
  std::set<std::int64_t> seeds;
  for (const SweepRow& row : rows)
    seeds.insert(row.accuracy.seeds.begin(), row.accuracy.seeds.end());
  return {seeds.begin(), seeds.end()};
}

std::string fewer_seeds_note(const std::vector<SweepRow>& rows, std::size_t all) {
  const auto has_fewer = [&](const SweepRow& row) { return row.accuracy.seeds.size() < all; };
  if (std::ranges::none_of(rows, has_fewer)) return "";
  return fmt::format(
      "{} marks numbers of fewer seeds than others of the table; the CSV file has their number.",
      mark_of_fewer_seeds);
}

std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows) {
  using Row = SweepRow;
  Columns<Row> columns;
  columns.field("dataset", [&](const Row&) { return sweep.grid.dataset; })
      .field("factor", [](const Row& row) { return row.point.factor; })
      .field("value", [](const Row& row) { return row.point.value; })
      .field("ratio", [](const Row& row) { return row.accuracy.ratio; })
      .field("seeds", [](const Row& row) { return count_cell(row.accuracy.summary.count); })
      .summary_fields("mean", "", [](const Row& row) { return row.accuracy.summary; });
  return columns.table(rows).csv();
}

Document sweep_document(const Sweep& sweep, const std::vector<SweepRow>& rows,
                        const run::Results& results) {
  Document document{
      .key = sweep.grid.dataset + "-sweep",
      .title = "Settings of " + augment::paper_method() + " on " + sweep.grid.dataset};
  const std::vector<std::int64_t> seeds = seeds_of_any_row(rows);
  const std::string fewer = fewer_seeds_note(rows, seeds.size());
  document.paragraphs.push_back(fmt::format(
      "Accuracy in percent with one setting moved and all others as in the grid (paper, Section "
      "4.5.5 and Fig. 19, which does not give numbers). Split protocol {}; {} ({}). "
      "Numbers are the mean ± the sample standard deviation over the seeds. {}{}",
      to_string(results.diagnoses.front().protocol), counted(seeds.size(), "seed"),
      seed_list(seeds), about_intervals, fewer.empty() ? "" : " " + fewer));
  for (const std::string& factor : factors_of(sweep)) {
    document.sections.push_back({factor, "By " + factor, "", factor_table(factor, rows)});
  }
  return document;
}

}  // namespace piae::report
