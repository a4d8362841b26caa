#include "page/cells_view.hpp"

#include <spdlog/fmt/fmt.h>

#include "page/links.hpp"
#include "page/table.hpp"
#include "scoring/quality_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

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
    for (std::size_t i = 0; i < dataset.diagnoses.size(); ++i) {
      const CellFile& cell = dataset.diagnoses[i];
      const double percent = 100 * dataset.results.diagnoses[i].accuracy;
      table.rows.push_back({.cells = {{.content = dataset.name},
                                      {.content = cell.name.method},
                                      {.content = cell.name.classifier},
                                      {.content = cell.name.ratio},
                                      seed_cell(cell.name.seed),
                                      number_cell(percent, fmt::format("{:.2f}", percent)),
                                      {.content = file_link(cell.file)},
                                      digest_cell(cell.digest)}});
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
    for (std::size_t i = 0; i < dataset.scores.size(); ++i) {
      const CellFile& cell = dataset.scores[i];
      Row row{.cells = {{.content = dataset.name},
                        {.content = cell.name.method},
                        seed_cell(cell.name.seed)}};
      for (const scoring::Metric& metric : scoring::all_metrics()) {
        const double mean = dataset.results.qualities[i].mean_over_classes(metric);
        row.cells.push_back(number_cell(mean, fmt::format("{:.4g}", mean)));
      }
      row.cells.push_back({.content = file_link(cell.file)});
      row.cells.push_back(digest_cell(cell.digest));
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Html in_details(const Table& table, const std::string& what) {
  if (table.rows.empty()) return {};
  return element("details", {{"class", "not-on-paper"}},
                 element("summary", fmt::format("{}: {}", what, table.rows.size())) + html(table));
}

}  // namespace

Html cells_view(const std::vector<DatasetContents>& datasets) {
  return element("p", fmt::format("What the means above were made from. A digest is the first {} "
                                  "of 64 digits of the SHA-256 of an artefact’s content; the "
                                  "program verify checks it.",
                                  shown_digits)) +
         in_details(diagnoses_table(datasets), "Diagnoses") +
         in_details(scores_table(datasets), "Scores");
}

}  // namespace piae::page
