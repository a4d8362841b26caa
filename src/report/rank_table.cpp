#include "report/rank_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

/// For each seed the accuracy of each method. Empty where a method has no row at this ratio.
std::vector<std::vector<double>> blocks_of(const std::vector<AccuracyRow>& rows,
                                           const std::vector<std::string>& methods,
                                           const std::string& ratio) {
  std::vector<std::vector<double>> blocks(rows.front().values.size());
  for (const std::string& method : methods) {
    const AccuracyRow* row = find_row(rows, method, ratio);
    if (row == nullptr) return {};
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].push_back(row->values[i]);
  }
  return blocks;
}

std::string note_of(const RankTable& table) {
  const scoring::AverageRanks& any = table.ratios.front().ranks;
  std::string note =
      "Rank of each method among the methods of the same seed, averaged over the seeds; 1 is the "
      "best, and equal ones share a rank. A ceiling does not compete; none does, at every ratio "
      "with "
      "its one accuracy.";
  if (!any.p) return note;
  return note + fmt::format(
                    " p: Friedman's test (Iman and Davenport) of all methods being alike. Ranks of "
                    "one ratio that differ by more than {:.2f} differ significantly at 0.05 "
                    "(Nemenyi; Demsar 2006). All cells together have no test, since those of one "
                    "seed are no independent repeats.",
                    *any.critical_difference);
}

}  // namespace

RankTable rank_methods(const std::vector<AccuracyRow>& rows) {
  RankTable table{.dataset = rows.front().dataset, .methods = methods_of(rows)};
  std::erase_if(table.methods, augment::is_ceiling);
  if (table.methods.size() < 2) return table;
  for (const RatioColumn& column : compared_columns(rows)) {
    const auto blocks = blocks_of(rows, table.methods, column.ratio);
    if (!blocks.empty()) table.ratios.push_back({column, scoring::average_ranks(blocks)});
  }
  if (table.ratios.empty()) return table;
  table.over_all_cells.resize(table.methods.size());
  for (const RatioRanks& ratio : table.ratios) {
    for (std::size_t i = 0; i < table.methods.size(); ++i) {
      table.over_all_cells[i] += ratio.ranks.average[i] / static_cast<double>(table.ratios.size());
    }
  }
  return table;
}

std::string ranks_csv(const RankTable& table) {
  std::string text = text::csv_line(
      {"dataset", "ratio", "method", "seeds", "average_rank", "friedman_p", "critical_difference"});
  for (const auto& [ratio, ranks] : table.ratios) {
    for (std::size_t i = 0; i < table.methods.size(); ++i) {
      text += text::csv_line({table.dataset, ratio.ratio, table.methods[i],
                              std::to_string(ranks.blocks), fmt::format("{:.4f}", ranks.average[i]),
                              ranks.p ? fmt::format("{:.6g}", *ranks.p) : "",
                              ranks.p ? fmt::format("{:.4f}", *ranks.critical_difference) : ""});
    }
  }
  for (std::size_t i = 0; i < table.over_all_cells.size(); ++i) {
    text += text::csv_line({table.dataset, "all", table.methods[i],
                            std::to_string(table.ratios.front().ranks.blocks),
                            fmt::format("{:.4f}", table.over_all_cells[i]), "", ""});
  }
  return text;
}

std::vector<Section> rank_sections(const RankTable& table) {
  if (table.ratios.empty()) return {};
  std::vector<std::string> header{"method"};
  std::vector<std::string> tests{"p"};
  for (const RatioRanks& ratio : table.ratios) {
    header.push_back(ratio.ratio.label);
    tests.push_back(ratio.ranks.p ? fmt::format("{:.3g}", *ratio.ranks.p) : "");
  }
  header.emplace_back("all cells");
  text::Table text(header, 1);
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    std::vector<std::string> cells{table.methods[i]};
    for (const RatioRanks& ratio : table.ratios) {
      cells.push_back(number_label(ratio.ranks.average[i]));
    }
    cells.push_back(number_label(table.over_all_cells[i]));
    text.row(cells);
  }
  if (table.ratios.front().ranks.p) text.row(tests);
  return {{"ranks", "Average ranks on " + table.dataset + PaperReference(table.dataset).none(),
           note_of(table), text}};
}

}  // namespace piae::report
