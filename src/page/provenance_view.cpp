#include "page/provenance_view.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "page/table.hpp"
#include "page/words.hpp"

namespace piae::page {

namespace {

using Builds = std::map<Build, std::size_t>;

Builds builds_of(const std::vector<DatasetContents>& datasets) {
  Builds builds;
  for (const DatasetContents& dataset : datasets) {
    for (const auto& [build, count] : dataset.builds) builds[build] += count;
  }
  return builds;
}

Html table_of_builds(const Builds& builds) {
  Table table{
      .caption = "What made the cells",
      .columns = {{"version (commit)"}, {"compiler and libraries"}, {"machine"}, {"cells", true}}};
  for (const auto& [build, count] : builds) {
    table.rows.push_back(
        {.cells = {{.content = build.version},
                   {.content = build.libraries},
                   {.content = build.processor},
                   number_cell(static_cast<double>(count), std::to_string(count))}});
  }
  table.below = "From /provenance of every diagnosis.h5 and score.h5.";
  return html(table);
}

/// Records of thousands of files would fill the page.
constexpr std::size_t most_files = 100;

Html table_of_records(const std::vector<DatasetContents>& datasets) {
  Table table{.caption = "What it was made from", .columns = {{"data set"}, {"file"}, {"SHA-256"}}};
  for (const DatasetContents& dataset : datasets) {
    if (dataset.records_digest.empty()) continue;
    table.rows.push_back({.cells = {{.content = dataset.name},
                                    {.content = "records.h5 (digest of its content)"},
                                    {.content = element("code", dataset.records_digest)}}});
    const std::size_t shown = std::min(dataset.records.size(), most_files);
    for (const RecordInput& input : std::span(dataset.records).first(shown)) {
      table.rows.push_back({.cells = {{.content = dataset.name},
                                      {.content = input.file},
                                      {.content = element("code", input.digest)}}});
    }
    if (shown < dataset.records.size()) {
      table.rows.push_back(
          {.cells = {{.content = dataset.name},
                     {.content = counted(dataset.records.size() - shown, "more file")},
                     {.content = "in records.h5"}}});
    }
  }
  if (table.rows.empty()) return {};
  table.below = "From /provenance/inputs of each data set’s records.h5.";
  return html(table);
}

}  // namespace

Html provenance_view(const std::vector<DatasetContents>& datasets) {
  const Builds builds = builds_of(datasets);
  Html view;
  if (builds.size() > 1) {
    view += element(
        "p", "The cells were made by " + counted(builds.size(), "different build") +
                 " or machines: numbers of different ones differ by rounding, which training makes "
                 "grow.");
  }
  if (!builds.empty()) view += table_of_builds(builds);
  return view + table_of_records(datasets);
}

}  // namespace piae::page
