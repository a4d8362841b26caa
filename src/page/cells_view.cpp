#include "page/cells_view.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "page/links.hpp"
#include "page/table.hpp"
#include "page/words.hpp"
#include "report/gaps.hpp"
#include "run/layout.hpp"
#include "scoring/quality_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace fs = std::filesystem;

namespace {

/// As much of a digest as tells it from all others; `verify` checks the whole.
constexpr std::size_t shown_digits = 16;

Cell seed_cell(std::int64_t seed) {
  return number_cell(static_cast<double>(seed), std::to_string(seed));
}

Cell digest_cell(const std::string& digest) {
  return {.content = element("code", digest.substr(0, shown_digits))};
}

Table diagnoses_table(const std::vector<DatasetContents>& datasets) {
  Table table{.caption = "Diagnoses: the attribute accuracy of each, percent",
              .columns = {{"data set"},
                          {"method"},
                          {"classifier"},
                          {"ratio"},
                          {"seed", true},
                          {"accuracy", true},
                          {"artefact"},
                          {"digest"}}};
  for (const DatasetContents& dataset : datasets) {
    const run::Layout layout("", dataset.name);
    for (std::size_t i = 0; i < dataset.results.diagnoses.size(); ++i) {
      const run::Diagnosis& cell = dataset.results.diagnoses[i];
      const double percent = 100 * cell.accuracy;
      const fs::path file = layout.diagnosis(cell.method, cell.ratio, cell.seed, cell.classifier);
      table.rows.push_back({.cells = {{.content = dataset.name},
                                      {.content = cell.method},
                                      {.content = cell.classifier},
                                      {.content = cell.ratio},
                                      seed_cell(cell.seed),
                                      number_cell(percent, fmt::format("{:.2f}", percent)),
                                      {.content = file_link(file)},
                                      digest_cell(dataset.diagnosis_digests[i])}});
    }
  }
  return table;
}

Table scores_table(const std::vector<DatasetContents>& datasets) {
  Table table{.caption = "Scores: the mean over classes of each metric",
              .columns = {{"data set"}, {"method"}, {"seed", true}}};
  for (const scoring::Metric& metric : scoring::all_metrics()) {
    table.columns.push_back({metric.name, true});
  }
  table.columns.insert(table.columns.end(), {{"artefact"}, {"digest"}});
  for (const DatasetContents& dataset : datasets) {
    const run::Layout layout("", dataset.name);
    for (std::size_t i = 0; i < dataset.results.qualities.size(); ++i) {
      const scoring::QualityRecord& cell = dataset.results.qualities[i];
      Row row{.cells = {{.content = dataset.name}, {.content = cell.method}, seed_cell(cell.seed)}};
      for (const scoring::Metric& metric : scoring::all_metrics()) {
        const double mean = cell.mean_over_classes(metric);
        row.cells.push_back(number_cell(mean, fmt::format("{:.4g}", mean)));
      }
      row.cells.push_back({.content = file_link(layout.score(cell.method, cell.seed))});
      row.cells.push_back(digest_cell(dataset.score_digests[i]));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

/// The cells of one combination, in the place of a row for each.
struct CombinedCells {
  const DatasetContents* dataset = nullptr;
  run::Combination combination;
  std::vector<std::int64_t> seeds = {};
  std::vector<double> percents = {};
};

/// Cells come by combination.
std::vector<CombinedCells> combined_diagnoses(const std::vector<DatasetContents>& datasets) {
  std::vector<CombinedCells> all;
  for (const DatasetContents& dataset : datasets) {
    for (const run::Diagnosis& cell : dataset.results.diagnoses) {
      const run::Combination combination{cell.method, cell.ratio, cell.classifier};
      const bool is_new =
          all.empty() || all.back().dataset != &dataset || !(all.back().combination == combination);
      if (is_new) all.push_back({.dataset = &dataset, .combination = combination});
      all.back().seeds.push_back(cell.seed);
      all.back().percents.push_back(100 * cell.accuracy);
    }
  }
  return all;
}

Table combined_table(const std::vector<DatasetContents>& datasets) {
  Table table{.caption = "Diagnoses: the lowest and the highest accuracy among the seeds, percent",
              .columns = {{"data set"},
                          {"method"},
                          {"classifier"},
                          {"ratio"},
                          {"diagnoses", true},
                          {"lowest", true},
                          {"highest", true},
                          {"seeds"}}};
  for (const CombinedCells& cells : combined_diagnoses(datasets)) {
    const auto [low, high] = std::ranges::minmax(cells.percents);
    table.rows.push_back({.cells = {{.content = cells.dataset->name},
                                    {.content = cells.combination.method},
                                    {.content = cells.combination.classifier},
                                    {.content = cells.combination.ratio},
                                    number_cell(static_cast<double>(cells.seeds.size()),
                                                std::to_string(cells.seeds.size())),
                                    number_cell(low, fmt::format("{:.2f}", low)),
                                    number_cell(high, fmt::format("{:.2f}", high)),
                                    {.content = report::seed_list(cells.seeds)}}});
  }
  return table;
}

Html in_details(const Table& table, const std::string& what) {
  if (table.rows.empty()) return {};
  return element("details", {{"class", "not-on-paper"}},
                 element("summary", fmt::format("{}: {}", what, table.rows.size())) + html(table));
}

std::size_t count_of_cells(const std::vector<DatasetContents>& datasets) {
  std::size_t count = 0;
  for (const DatasetContents& dataset : datasets) {
    count += dataset.results.diagnoses.size() + dataset.results.qualities.size();
  }
  return count;
}

}  // namespace

Html cells_view(const std::vector<DatasetContents>& datasets) {
  const std::size_t count = count_of_cells(datasets);
  if (count > most_listed_cells) {
    return element("p",
                   fmt::format(
                       "The means above were made from {} cells. A row for each would make this "
                       "page too large to send, so there is one for all seeds of a diagnosis. "
                       "Each cell lies in DATASET/seedN/METHOD/: score.h5, and below it in "
                       "RATIO/CLASSIFIER/ diagnosis.h5. The program verify checks their digests.",
                       count)) +
           in_details(combined_table(datasets), "Diagnoses by method, classifier and ratio");
  }
  return element("p", fmt::format("What the means above were made from. A digest is the first {} "
                                  "of 64 digits of the SHA-256 of an artefact’s content; the "
                                  "program verify checks it.",
                                  shown_digits)) +
         in_details(diagnoses_table(datasets), "Diagnoses") +
         in_details(scores_table(datasets), "Scores");
}

}  // namespace piae::page
