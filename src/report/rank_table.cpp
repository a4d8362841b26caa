#include "report/rank_table.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/ratio_means.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

/// A ratio and a seed at which methods can be ranked.
struct RankedCell {
  RatioColumn ratio;
  std::int64_t seed;
};

std::vector<RankedCell> cells_of_any(const std::vector<AccuracyRow>& rows) {
  const std::vector<std::int64_t> seeds = seeds_of_any(rows);
  std::vector<RankedCell> cells;
  for (const RatioColumn& ratio : compared_columns(rows)) {
    for (const std::int64_t seed : seeds) cells.push_back({ratio, seed});
  }
  return cells;
}

std::optional<double> value_at(const std::vector<AccuracyRow>& rows, const std::string& method,
                               const RankedCell& cell) {
  const AccuracyRow* const row = find_row(rows, method, cell.ratio.ratio);
  return row == nullptr ? std::nullopt : row->at(cell.seed);
}

/// True if p of Friedman's test cannot be small with so few seeds, even if all rank the methods
/// alike.
bool cannot_be_small(const scoring::AverageRanks& ranks) {
  const auto methods = static_cast<double>(ranks.average.size());
  return std::pow(std::tgamma(methods + 1), 1 - static_cast<double>(ranks.blocks)) >
         significance_level;
}

std::string test_label(const scoring::AverageRanks& ranks) {
  if (!ranks.p) return no_number;
  return fmt::format("{:.3g}{}", *ranks.p,
                     cannot_be_small(ranks) ? std::string(" ") + mark_of_large_p : "");
}

/// Returns what the tests mean, and what so few seeds cannot show.
std::string tests_note(const RankTable& table) {
  double critical = 0;
  bool few = false;
  for (const RatioRanks& ratio : table.ratios) {
    if (!ratio.ranks.p) continue;
    critical = std::max(critical, *ratio.ranks.critical_difference);
    few = few || cannot_be_small(ratio.ranks);
  }
  const std::size_t largest = table.methods.size() - 1;  // between the first and the last rank
  std::string note = fmt::format(
      " p: Friedman's test (Iman and Davenport) of the hypothesis that all methods are equal. "
      "Ranks of one ratio "
      "that "
      "differ by more than {:.2f} differ significantly at {} (Nemenyi; Demsar 2006){}. All cells "
      "together are not tested, because cells of one seed are not independent repeats.",
      critical, significance_level,
      critical < static_cast<double>(largest)
          ? ""
          : fmt::format(", but ranks of {} methods cannot differ that much", table.methods.size()));
  if (few) {
    note += fmt::format(" {} marks p values that so few seeds cannot make smaller than {}.",
                        mark_of_large_p, significance_level);
  }
  return note;
}

std::string left_out_note(const RankTable& table) {
  if (table.left_out.empty() && table.has_every_seed) return "";
  const std::string names = fmt::format("{}", fmt::join(table.left_out, ", "));
  return " Ranks use the cells that all of these methods have" +
         (names.empty() ? "" : "; left out, because they have too few: " + names) + ".";
}

std::string note_of(const RankTable& table) {
  const auto is_tested = [](const RatioRanks& ratio) { return ratio.ranks.p.has_value(); };
  return "Rank of each method among the methods of the same seed, averaged over the seeds; 1 is "
         "the best, and equal methods share a rank. Ceilings are not ranked; none is ranked at "
         "every ratio with its one accuracy." +
         left_out_note(table) +
         (std::ranges::any_of(table.ratios, is_tested) ? tests_note(table) : "");
}

/// Returns the ranks at each ratio of the block, over the block's seeds at that ratio.
std::vector<RatioRanks> ranks_of(const std::vector<AccuracyRow>& rows,
                                 const std::vector<std::string>& methods,
                                 const std::vector<RankedCell>& cells) {
  std::vector<RatioRanks> ratios;
  for (auto first = cells.begin(); first != cells.end();) {
    const auto end = std::find_if(first, cells.end(), [&](const RankedCell& cell) {
      return cell.ratio.ratio != first->ratio.ratio;
    });
    std::vector<std::vector<double>> blocks;
    for (auto cell = first; cell != end; ++cell) {
      std::vector<double>& block = blocks.emplace_back();
      for (const std::string& method : methods) block.push_back(*value_at(rows, method, *cell));
    }
    ratios.push_back({first->ratio, scoring::average_ranks(blocks)});
    first = end;
  }
  return ratios;
}

std::string csv_lines(const RankTable& table) {
  std::string text;
  for (const auto& [ratio, ranks] : table.ratios) {
    for (std::size_t i = 0; i < table.methods.size(); ++i) {
      text += text::csv_line({table.dataset, ratio.ratio, table.methods[i], table.classifier,
                              std::to_string(ranks.blocks), fmt::format("{:.4f}", ranks.average[i]),
                              ranks.p ? fmt::format("{:.6g}", *ranks.p) : "",
                              ranks.p ? fmt::format("{:.4f}", *ranks.critical_difference) : ""});
    }
  }
  for (std::size_t i = 0; i < table.over_all_cells.size(); ++i) {
    text += text::csv_line({table.dataset, "all", table.methods[i], table.classifier,
                            std::to_string(table.ratios.front().ranks.blocks),
                            fmt::format("{:.4f}", table.over_all_cells[i]), "", ""});
  }
  return text;
}

}  // namespace

RankTable rank_methods(const std::vector<AccuracyRow>& rows) {
  RankTable table{
      .dataset = rows.front().dataset, .classifier = rows.front().classifier, .methods = {}};
  std::vector<std::string> methods = methods_of(rows);
  std::erase_if(methods, augment::is_ceiling);
  const std::vector<RankedCell> cells = cells_of_any(rows);
  const auto has = [&](std::size_t m, std::size_t c) {
    return value_at(rows, methods[m], cells[c]).has_value();
  };
  const Block block = largest_block(columns_of_rows(methods.size(), cells.size(), has), 2, 1);
  if (block.rows.empty()) return table;
  std::vector<RankedCell> ranked;
  for (const std::size_t c : block.columns) ranked.push_back(cells[c]);
  table.has_every_seed = ranked.size() == cells.size();
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const bool is_ranked = std::ranges::find(block.rows, m) != block.rows.end();
    (is_ranked ? table.methods : table.left_out).push_back(methods[m]);
  }
  table.ratios = ranks_of(rows, table.methods, ranked);
  table.over_all_cells.resize(table.methods.size());
  for (const RatioRanks& ratio : table.ratios) {
    for (std::size_t i = 0; i < table.methods.size(); ++i) {
      table.over_all_cells[i] += ratio.ranks.average[i] / static_cast<double>(table.ratios.size());
    }
  }
  return table;
}

std::vector<RankTable> rank_by_classifier(const std::vector<AccuracyRow>& rows) {
  std::vector<RankTable> tables;
  for (const ClassifierRows& block : by_classifier(rows))
    tables.push_back(rank_methods(block.rows));
  return tables;
}

std::string ranks_csv(const std::vector<RankTable>& tables) {
  std::string text = text::csv_line({"dataset", "ratio", "method", "classifier", "seeds",
                                     "average_rank", "friedman_p", "critical_difference"});
  for (const RankTable& table : tables) text += csv_lines(table);
  return text;
}
std::vector<Section> rank_sections(const RankTable& table) {
  if (table.ratios.empty()) return {};
  std::vector<std::string> header{"method"};
  std::vector<std::string> tests{"p"};
  bool is_tested = false;
  for (const RatioRanks& ratio : table.ratios) {
    header.push_back(ratio.ratio.label);
    tests.push_back(test_label(ratio.ranks));
    is_tested = is_tested || ratio.ranks.p;
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
  if (is_tested) text.row(tests);
  return {PaperReference(table.dataset, table.classifier)
              .none()
              .of({"ranks", "Average ranks on " + table.dataset, note_of(table), text})};
}

}  // namespace piae::report
