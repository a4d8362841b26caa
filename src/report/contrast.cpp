#include "report/contrast.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "report/ratio_means.hpp"
#include "run/held.hpp"

namespace piae::report {

namespace {

/// Names of both sides in tables and files.
struct Names {
  std::string with;
  std::string without;
};

/// Names both sides by what differs between them. The names are empty if nothing differs.
Names names_of(const Side& with, const Side& without) {
  Names names;
  const auto add = [&](const std::string& one, const std::string& other) {
    if (one == other) return;
    names.with += (names.with.empty() ? "" : " ") + one;
    names.without += (names.without.empty() ? "" : " ") + other;
  };
  add(with.dataset, without.dataset);
  add(to_string(with.protocol), to_string(without.protocol));
  if (names.with.empty()) add(with.run.filename(), without.run.filename());
  return names;
}

/// One line, with the numbers of both sides.
struct ContrastLine {
  std::string name;  ///< name of the method; empty if the line above has the same
  const PairedRow* row;
  const scoring::Summary* with;
  const scoring::Summary* without;
};

/// Returns a block for each method, with a row for each ratio and the means of both sides.
text::Table sides_table(const Contrast& contrast, const Names& names) {
  using Line = ContrastLine;
  std::vector<Line> lines;
  for (const std::vector<const PairedRow*>& block : blocks_of(contrast.rows)) {
    std::string name = block_label(block, contrast.rows);
    for (const PairedRow* const row : block) {
      const std::size_t i = row - contrast.rows.data();
      lines.push_back(
          {name, row, &contrast.with.rows[i].summary, &contrast.without.rows[i].summary});
      name.clear();
    }
  }
  Columns<Line> columns;
  columns.words("method", &Line::name)
      .words("ratio", [](const Line& line) { return line.row->ratio_label; })
      .numbers(names.with, [](const Line& line) { return mean_cell(*line.with); })
      .numbers(names.without, [](const Line& line) { return mean_cell(*line.without); });
  return columns.table(lines);
}

/// Returns the layout of a folder RUN/DATASET. The folder may end with a slash.
run::Layout layout_of(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder.has_filename() ? folder : folder.parent_path();
  return {path.parent_path(), path.filename()};
}

/// Reads one side: the requested cells, and other cells that both sides have.
Side read_side(const run::Layout& layout, const run::Layout& other, run::GridOptions read,
               const std::vector<std::string>& leave_out) {
  read.dataset = layout.folder().filename();
  const run::Collected all = collect_held_diagnoses(
      layout, resolve(read), run::Held(layout, other, leave_out), run::Classifiers::papers);
  run::require_all(all.results);
  return {.run = layout.folder().parent_path(),
          .dataset = all.grid.dataset,
          .protocol = all.results.diagnoses.front().protocol,
          .rows = with_means(accuracy_rows(all.grid, all.results, Published())),
          .gaps = gap_paragraphs(all.grid, all.results)};
}

}  // namespace

Contrast read_contrast(const Folders& folders, const run::GridOptions& read,
                       const std::vector<std::string>& leave_out) {
  const run::Layout with = layout_of(folders.with);
  const run::Layout without = layout_of(folders.without);
  return contrast(read_side(with, without, read, leave_out),
                  read_side(without, with, read, leave_out));
}

Contrast contrast(Side with, Side without) {
  if (names_of(with, without).with.empty()) {
    throw Error(Exit::usage, "--with and --without: both are " + with.dataset + ", " +
                                 to_string(with.protocol) +
                                 ", of a run of the same name; name two that differ");
  }
  Contrast contrast{.with = std::move(with), .without = std::move(without)};
  for (std::size_t i = 0; i < contrast.with.rows.size(); ++i) {
    const auto pair = paired_row(contrast.with.rows[i], contrast.without.rows[i]);
    contrast.rows.push_back(pair.value());
  }
  add_holm_p(contrast.rows);
  return contrast;
}

std::string contrast_csv(const Contrast& contrast) {
  using Line = ContrastLine;
  std::vector<Line> lines;
  for (std::size_t i = 0; i < contrast.rows.size(); ++i) {
    lines.push_back(
        {"", &contrast.rows[i], &contrast.with.rows[i].summary, &contrast.without.rows[i].summary});
  }
  const Names names = names_of(contrast.with, contrast.without);
  Columns<Line> columns;
  columns.field("with", [&](const Line&) { return names.with; })
      .field("without", [&](const Line&) { return names.without; })
      .field("method", [](const Line& line) { return line.row->method; })
      .field("ratio", [](const Line& line) { return line.row->ratio; })
      .summary_fields(
          "with_mean", "with_", [](const Line& line) { return *line.with; }, false)
      .summary_fields(
          "without_mean", "without_", [](const Line& line) { return *line.without; }, false)
      .with(paired_columns(), [](const Line& line) { return *line.row; });
  return columns.table(lines).csv();
}

Document contrast_document(const Contrast& contrast) {
  const Names names = names_of(contrast.with, contrast.without);
  const std::string& dataset = contrast.with.dataset;
  const std::string what = names.with + " against " + names.without;
  const bool same_dataset = dataset == contrast.without.dataset;
  Document document{.key = dataset, .title = (same_dataset ? dataset + ": " : "") + what};
  document.paragraphs.push_back(
      fmt::format("Effect of {}: accuracy in percent with it and with {} instead; the difference "
                  "is the first minus the second. Each side has its own splits: a pair shares the "
                  "seed, not the windows. Numbers are the mean ± the sample "
                  "standard deviation over the seeds. {}",
                  names.with, names.without, about_intervals));
  document.paragraphs.insert(document.paragraphs.end(), contrast.with.gaps.begin(),
                             contrast.with.gaps.end());
  document.sections.push_back(
      {"contrast", "Accuracy, " + what + ", percent", "", sides_table(contrast, names)});
  document.sections.push_back({"difference",
                               "Difference, " + names.with + " minus " + names.without + ", points",
                               paired_note(contrast.rows), paired_table(contrast.rows)});
  return document;
}

}  // namespace piae::report
