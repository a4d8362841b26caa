#include "page/cells_view.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <span>

#include "diagnosis/catalogue.hpp"
#include "page/html.hpp"
#include "page/table.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "run/layout.hpp"
#include "scoring/quality_record.hpp"
#include "scoring/ratios.hpp"

namespace piae::page {

namespace fs = std::filesystem;
using report::Section;

namespace {

/// Number of digits that identify an artefact; `verify` checks the whole digest.
constexpr std::size_t shown_digits = 16;

text::Cell digest_cell(const std::string& digest) {
  text::Cell cell = digest;
  cell.is_digest = true;
  return cell;
}

text::Cell file_cell(const fs::path& file) {
  text::Cell cell;
  cell.files = {file};
  return cell;
}

text::Cell seed_cell(std::int64_t seed) {
  return report::labelled_cell(static_cast<double>(seed), std::to_string(seed));
}

Section diagnoses_table(const std::vector<DatasetContents>& datasets) {
  text::Table table({"data set", "method", "classifier", "ratio"}, 4);
  for (const char* heading : {"seed", "accuracy"}) table.column({heading, true});
  for (const char* heading : {"artefact", "digest"}) table.column({heading});
  for (const DatasetContents& dataset : datasets) {
    const run::Layout layout("", dataset.name);
    for (std::size_t i = 0; i < dataset.results.diagnoses.size(); ++i) {
      const run::Diagnosis& cell = dataset.results.diagnoses[i];
      table.row({dataset.name, cell.method, diagnosis::marked_name(cell.classifier), cell.ratio,
                 seed_cell(cell.seed), report::number_cell(100 * cell.accuracy),
                 file_cell(layout.diagnosis(cell.method, cell.ratio, cell.seed, cell.classifier)),
                 digest_cell(dataset.diagnosis_digests[i].substr(0, shown_digits))});
    }
  }
  return {"diagnoses", "Diagnoses: the attribute accuracy of each, percent", "", table};
}

Section scores_table(const std::vector<DatasetContents>& datasets) {
  text::Table table({"data set", "method", "seed"}, 2);
  for (const scoring::Metric& metric : scoring::all_metrics()) table.column({metric.name, true});
  for (const char* heading : {"artefact", "digest"}) table.column({heading});
  for (const DatasetContents& dataset : datasets) {
    const run::Layout layout("", dataset.name);
    for (std::size_t i = 0; i < dataset.results.qualities.size(); ++i) {
      const scoring::QualityRecord& cell = dataset.results.qualities[i];
      text::Cells row{dataset.name, cell.method, seed_cell(cell.seed)};
      for (const scoring::Metric& metric : scoring::all_metrics()) {
        const double mean = cell.mean_over_classes(metric);
        row.push_back(report::labelled_cell(mean, fmt::format("{:.4g}", mean)));
      }
      row.push_back(file_cell(layout.score(cell.method, cell.seed)));
      row.push_back(digest_cell(dataset.score_digests[i].substr(0, shown_digits)));
      table.row(std::move(row));
    }
  }
  return {"scores", "Scores: the mean over classes of each metric", "", table};
}

/// Returns a row for all seeds of a diagnosis, because accuracy_rows() combine them.
Section combined_table(const std::vector<DatasetContents>& datasets) {
  text::Table table({"data set", "method", "classifier", "ratio"}, 4);
  for (const char* heading : {"diagnoses", "lowest", "highest"}) table.column({heading, true});
  table.column({"seeds"});
  for (const DatasetContents& dataset : datasets) {
    for (const report::AccuracyRow& row : dataset.rows) {
      const auto [low, high] = std::ranges::minmax(row.values);
      table.row({dataset.name, row.method, diagnosis::marked_name(row.classifier), row.ratio,
                 report::count_cell(row.values.size()), report::number_cell(low),
                 report::number_cell(high), report::seed_list(row.seeds)});
    }
  }
  return {"diagnoses", "Diagnoses: the lowest and the highest accuracy among the seeds, percent",
          "", table};
}

Html in_details(const Section& section, const std::string& what) {
  const std::size_t rows = section.table.rows().size();
  if (rows == 0) return {};
  return element("details", {{"class", "not-on-paper"}},
                 element("summary", fmt::format("{}: {}", what, rows)) + html(section));
}

std::size_t count_of_cells(const std::vector<DatasetContents>& datasets) {
  std::size_t count = 0;
  for (const DatasetContents& dataset : datasets) {
    count += dataset.results.diagnoses.size() + dataset.results.qualities.size();
  }
  return count;
}

using Builds = std::map<Build, std::size_t>;

Builds builds_of(const std::vector<DatasetContents>& datasets) {
  Builds builds;
  for (const DatasetContents& dataset : datasets) {
    for (const auto& [build, count] : dataset.builds) builds[build] += count;
  }
  return builds;
}

Html table_of_builds(const Builds& builds) {
  text::Table table({"version (commit)", "compiler and libraries", "machine", "cells"}, 3);
  for (const auto& [build, count] : builds) {
    table.row({build.version, build.libraries, build.processor, report::count_cell(count)});
  }
  return html(report::Section{"builds", "Builds and machines of the cells",
                              "From /provenance of every diagnosis.h5 and score.h5.", table});
}

/// Limit of listed files, because thousands of records would fill the page.
constexpr std::size_t most_files = 100;

Html table_of_records(const std::vector<DatasetContents>& datasets) {
  text::Table table({"data set", "file", "SHA-256"}, 3);
  for (const DatasetContents& dataset : datasets) {
    if (dataset.records_digest.empty()) continue;
    table.row(
        {dataset.name, "records.h5 (digest of its content)", digest_cell(dataset.records_digest)});
    const std::size_t shown = std::min(dataset.records.size(), most_files);
    for (const RecordInput& input : std::span(dataset.records).first(shown)) {
      table.row({dataset.name, input.file, digest_cell(input.digest)});
    }
    if (shown < dataset.records.size()) {
      table.row({dataset.name, report::counted(dataset.records.size() - shown, "more file"),
                 "in records.h5"});
    }
  }
  if (table.rows().empty()) return {};
  return html(report::Section{"records", "Source files",
                              "From /provenance/inputs of each data set’s records.h5.", table});
}

}  // namespace

namespace fs = std::filesystem;
using report::Section;

Html cells_view(const std::vector<DatasetContents>& datasets) {
  const std::size_t count = count_of_cells(datasets);
  if (count > most_listed_cells) {
    return element("p",
                   fmt::format(
                       "The means above were made from {} cells. A row for each would make this "
                       "page too large to send, so one row covers all seeds of a diagnosis. Each "
                       "cell lies in DATASET/seedN/METHOD/: score.h5, and below it in "
                       "RATIO/CLASSIFIER/ diagnosis.h5. The program verify checks their digests.",
                       count)) +
           in_details(combined_table(datasets), "Diagnoses by method, classifier and ratio");
  }
  return element("p", fmt::format(
                          "The cells behind the means above. A digest is the first {} of 64 digits "
                          "of the SHA-256 of an artefact’s content; the program verify checks it.",
                          shown_digits)) +
         in_details(diagnoses_table(datasets), "Diagnoses") +
         in_details(scores_table(datasets), "Scores");
}

Html provenance_view(const std::vector<DatasetContents>& datasets) {
  const Builds builds = builds_of(datasets);
  Html view;
  if (builds.size() > 1) {
    view += element(
        "p",
        "The cells were made by " + report::counted(builds.size(), "different build") +
            " or machines: their numbers differ by rounding errors, which training amplifies.");
  }
  if (!builds.empty()) view += table_of_builds(builds);
  return view + table_of_records(datasets);
}

}  // namespace piae::page
