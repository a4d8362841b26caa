#include "report/contrast.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/ratio_columns.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;

/// The names of both sides in tables and files.
struct Names {
  std::string with;
  std::string without;
};

/// Names both sides by what differs between them. Empty names where nothing does.
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

/// The accuracies of one side, with a ratio in each column. `first` stands before the side's name.
Cells side_line(const std::string& first, const std::string& name, const Side& side,
                const std::string& method, const std::vector<RatioColumn>& columns) {
  Cells cells{first, name};
  for (const RatioColumn& column : columns) {
    const auto row = std::ranges::find_if(side.rows, [&](const AccuracyRow& each) {
      return each.method == method && each.ratio == column.ratio;
    });
    cells.push_back(row == side.rows.end() ? "" : mean_label(row->summary));
  }
  return cells;
}

text::Table table_of(const Contrast& contrast, const Names& names) {
  const std::vector<RatioColumn> columns = ratio_columns(contrast.with.rows);
  Cells header{"method", ""};
  for (const RatioColumn& column : columns) header.push_back(column.label);
  text::Table table(header, 2);
  for (const std::string& method : methods_of(contrast.with.rows)) {
    table.row(side_line(method_label(method), names.with, contrast.with, method, columns));
    table.row(side_line("", names.without, contrast.without, method, columns));
    add_paired_lines(table, "", method, contrast.rows, columns);
  }
  return table;
}

}  // namespace

Side read_side(const std::filesystem::path& folder, run::GridOptions options) {
  const std::filesystem::path path = folder.has_filename() ? folder : folder.parent_path();
  options.dataset = path.filename();
  run::Grid grid = resolve(options);
  grid.scored.clear();  // accuracies alone are compared
  const run::Results results = collect(run::Layout(path.parent_path(), grid.dataset), grid);
  run::require_all(results);
  return {.run = path.parent_path(),
          .dataset = grid.dataset,
          .protocol = results.diagnoses.front().protocol,
          .rows = with_means(accuracy_rows(grid, results, Published()))};
}

Contrast contrast(Side with, Side without) {
  if (names_of(with, without).with.empty()) {
    throw Error(Exit::usage, "--with and --without: both are " + with.dataset + ", " +
                                 to_string(with.protocol) +
                                 ", of a run of the same name; name two that differ");
  }
  Contrast contrast{.with = std::move(with), .without = std::move(without)};
  for (std::size_t i = 0; i < contrast.with.rows.size(); ++i) {
    const AccuracyRow& row = contrast.with.rows[i];
    contrast.rows.push_back(paired_row(row, row.ratio, contrast.without.rows[i]));
  }
  add_holm_p(contrast.rows);
  return contrast;
}

std::string contrast_csv(const Contrast& contrast) {
  const Names names = names_of(contrast.with, contrast.without);
  std::string text = joined_csv_line({{"with", "without", "method", "ratio", "with_mean",
                                       "with_std", "without_mean", "without_std"},
                                      paired_header()});
  for (std::size_t i = 0; i < contrast.rows.size(); ++i) {
    const PairedRow& row = contrast.rows[i];
    text += joined_csv_line({{names.with, names.without, row.method, row.ratio},
                             mean_fields(contrast.with.rows[i].summary),
                             mean_fields(contrast.without.rows[i].summary),
                             paired_fields(row)});
  }
  return text;
}

Document contrast_document(const Contrast& contrast) {
  const Names names = names_of(contrast.with, contrast.without);
  const std::string& dataset = contrast.with.dataset;
  const std::string what = names.with + " against " + names.without;
  const bool same_dataset = dataset == contrast.without.dataset;
  Document document{.key = dataset, .title = (same_dataset ? dataset + ": " : "") + what};
  document.paragraphs.push_back(
      "What " + names.with + " is worth: accuracy in percent with it, and with " + names.without +
      " in its place; the difference is the first minus the second. Each "
      "side has splits of its own: a pair has the seed in common, not "
      "the windows. " +
      paired_note(contrast.rows));
  document.sections.push_back({"contrast", "Accuracy, " + what, "", table_of(contrast, names)});
  return document;
}

}  // namespace piae::report
