#include "report/markdown.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "report/text_table.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;

std::string percent_label(double percent) { return fmt::format("{:.2f}", percent); }

/// " (the paper's Table 6)" for a dataset that is in the paper.
std::string paper_table(const std::string& dataset, int for_cwru, int for_hfhp) {
  if (dataset == "cwru") return fmt::format(" (the paper's Table {})", for_cwru);
  if (dataset == "hfhp") return fmt::format(" (the paper's Table {})", for_hfhp);
  return "";
}

Cells runs_row(const std::string& name, const std::vector<double>& percents, std::size_t runs) {
  Cells cells{name};
  for (const double percent : percents) cells.push_back(percent_label(percent));
  cells.resize(runs + 1);
  return cells;
}

std::string seeds_label(const std::vector<std::int64_t>& seeds) {
  std::string label = seeds.size() == 1 ? "here, seed" : "here, seeds";
  for (const std::int64_t seed : seeds) label += " " + std::to_string(seed);
  return label;
}

/// Table 6: a run a column, ours above the paper's.
std::string baseline_table(const Grid& grid, const AccuracyRow& row, const Published& published) {
  const std::vector<double> theirs = published.baseline_runs(grid.dataset);
  const std::size_t runs = std::max(row.percents.size(), theirs.size());
  Cells header{""};
  for (std::size_t i = 0; i < runs; ++i) header.push_back("run " + std::to_string(i + 1));
  header.insert(header.end(), {"mean", "95 % interval"});
  TextTable table(header, 1);
  Cells ours = runs_row(seeds_label(grid.seeds), row.percents, runs);
  ours.insert(ours.end(), {mean_label(row.summary), interval_label(row.summary)});
  table.row(ours);
  if (row.published) {
    Cells paper = runs_row("paper", theirs, runs);
    paper.push_back(percent_label(*row.published));
    table.row(paper);
  }
  return table.markdown();
}

/// The columns of Table 8: one row of `rows` for each ratio.
std::vector<const AccuracyRow*> one_of_each_ratio(const std::vector<AccuracyRow>& rows) {
  std::vector<const AccuracyRow*> ratios;
  for (const AccuracyRow& row : rows) {
    const auto same = [&](const AccuracyRow* other) { return other->ratio == row.ratio; };
    if (row.method != no_method && std::ranges::none_of(ratios, same)) ratios.push_back(&row);
  }
  return ratios;
}

void add_method(TextTable& table, const std::string& method, const std::vector<AccuracyRow>& rows) {
  Cells ours{method, "here"};
  Cells intervals{"", "95 %"};
  Cells paper{"", "paper"};
  bool in_paper = false;
  for (const AccuracyRow& row : rows) {
    if (row.method != method) continue;
    ours.push_back(mean_label(row.summary));
    intervals.push_back(interval_label(row.summary));
    paper.push_back(row.published ? percent_label(*row.published) : "");
    in_paper = in_paper || row.published;
  }
  table.row(ours);
  if (rows.front().summary.interval) table.row(intervals);
  if (in_paper) table.row(paper);
}

/// Table 8: a ratio a column, up to three lines a method.
std::string methods_table(const Grid& grid, const std::vector<AccuracyRow>& rows) {
  Cells header{"method", ""};
  for (const AccuracyRow* row : one_of_each_ratio(rows)) header.push_back(ratio_label(*row));
  TextTable table(header, 2);
  for (const std::string& method : grid.generators) add_method(table, method, rows);
  return table.markdown();
}

}  // namespace

std::string tables_markdown(const Grid& grid, const Results& results,
                            const std::vector<AccuracyRow>& rows, const Published& published) {
  std::string text = fmt::format(
      "# Diagnostic accuracy on {}\n\n"
      "Percent. Split protocol `{}`; {} seed{}, each with a split, a generator and a classifier of "
      "its own.\nMean ± sample standard deviation over the seeds, 95 % interval of the mean by "
      "Student's t; `paper` is the\nfigure that the paper publishes. Ratios are normal windows to "
      "those of each fault class, as the paper\nnames them; where the true one differs it follows "
      "in brackets.\n",
      grid.dataset, results.diagnoses.front().protocol, grid.seeds.size(),
      grid.seeds.size() == 1 ? "" : "s");
  const auto baseline = std::ranges::find(rows, no_method, &AccuracyRow::method);
  if (baseline != rows.end()) {
    text += "\n## Without augmentation, " + ratio_label(*baseline) +
            paper_table(grid.dataset, 6, 7) + "\n\n" + baseline_table(grid, *baseline, published);
  }
  if (!one_of_each_ratio(rows).empty()) {
    text += "\n## With augmentation" + paper_table(grid.dataset, 8, 9) + "\n\n" +
            methods_table(grid, rows);
  }
  return text;
}

}  // namespace piae::report
