#include "report/paired_rows.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/labels.hpp"
#include "report/ratio_means.hpp"

namespace piae::report {

namespace {

constexpr NumberStyle difference_style{.decimals = 2, .sign = true};

bool is_tested(const PairedRow& row) { return row.paired.p.has_value(); }
/// True if a row is one of the tests that are corrected together. A ceiling is not a method and
/// therefore not among them.
bool is_in_a_family(const PairedRow& row) {
  return is_tested(row) && !augment::is_ceiling(row.method);
}
bool has_an_interval(const PairedRow& row) { return row.paired.difference.interval.has_value(); }

std::string p_label(const PairedRow& row) {
  if (!is_tested(row)) return no_number;
  const std::string corrected = row.p_holm ? fmt::format(" ({:.3g})", *row.p_holm) : "";
  return fmt::format("{:.3g}{}{}", *row.paired.p, corrected,
                     row.p_can_be_small ? "" : std::string(" ") + mark_of_large_p);
}

std::string effect_label(const PairedRow& row) {
  return is_tested(row) ? number_label(row.paired.rank_biserial, difference_style) : no_number;
}

std::string ratio_label_of(const AccuracyRow& row) {
  return row.ratio == mean_of_ratios ? fmt::format("mean of {}", row.ratios)
                                     : ratio_label(row.ratio, row.true_ratio);
}

/// Returns the number of tests that a row is corrected with, itself included.
std::size_t family_of(const PairedRow& row, const std::vector<PairedRow>& rows) {
  if (!is_in_a_family(row)) return 1;
  return static_cast<std::size_t>(std::ranges::count_if(rows, [&](const PairedRow& each) {
    return each.ratio == row.ratio && is_in_a_family(each);
  }));
}

/// Returns the smallest p that `seeds` seeds can give after Holm's correction for `tests` tests.
double smallest_corrected_p(std::size_t seeds, std::size_t tests) {
  return std::min(1.0, scoring::smallest_p(seeds) * static_cast<double>(tests));
}

/// Returns "2 seeds cannot give a p below 0.5, which Holm's correction for 2 makes 1".
std::string limit_of(std::size_t seeds, std::size_t tests) {
  const double smallest = scoring::smallest_p(seeds);
  std::string text = fmt::format("{} seeds cannot give a p below {:.3g}", seeds, smallest);
  if (tests > 1) {
    text += fmt::format(", which Holm's correction for {} makes {:.3g}", tests,
                        smallest_corrected_p(seeds, tests));
  }
  return text;
}

/// Returns a warning if even the smallest p of so few seeds is not significant; "" otherwise. The
/// warning names the limit for each number of seeds.
std::string warning_of_few_seeds(const std::vector<PairedRow>& rows) {
  std::map<std::size_t, std::size_t> largest_family;  // by the number of seeds
  for (const PairedRow& row : rows) {
    if (row.p_can_be_small) continue;
    std::size_t& largest = largest_family[row.paired.difference.count];
    largest = std::max(largest, family_of(row, rows));
  }
  std::string limits;
  for (const auto& [seeds, tests] : largest_family) {
    limits += (limits.empty() ? "" : "; ") + limit_of(seeds, tests);
  }
  if (limits.empty()) return "";
  return fmt::format(
      " {} marks p values that cannot be small: {}. However large such a difference is, it cannot "
      "be significant at {} here.",
      mark_of_large_p, limits, significance_level);
}

}  // namespace

std::optional<PairedRow> paired_row(const AccuracyRow& row, const AccuracyRow& other) {
  Pairs pairs = pairs_of(row, other);
  if (pairs.seeds.empty()) return std::nullopt;
  const bool at_other = row.method == augment::no_method && other.method != augment::no_method;
  const AccuracyRow& at = at_other ? other : row;
  std::vector<double> differences(pairs.seeds.size());
  std::ranges::transform(pairs.first, pairs.second, differences.begin(), std::minus());
  PairedRow paired{.method = row.method,
                   .ratio = at.ratio,
                   .ratio_label = ratio_label_of(at),
                   .seeds = std::move(pairs.seeds),
                   .differences = std::move(differences),
                   .paired = scoring::paired_difference(pairs.first, pairs.second)};
  bound(paired.paired.difference, differences_of_percents);
  return paired;
}

void add_holm_p(std::vector<PairedRow>& rows) {
  std::set<std::string> ratios;
  for (const PairedRow& row : rows) ratios.insert(row.ratio);
  for (const std::string& ratio : ratios) {
    std::vector<PairedRow*> family;
    std::vector<double> p;
    for (PairedRow& row : rows) {
      if (row.ratio != ratio || !is_in_a_family(row)) continue;
      family.push_back(&row);
      p.push_back(*row.paired.p);
    }
    const std::vector<double> corrected = scoring::holm(p);
    for (std::size_t i = 0; i < family.size(); ++i) {
      family[i]->p_holm = corrected[i];
    }
  }
  for (PairedRow& row : rows) {
    row.p_can_be_small = !is_tested(row) || least_p_of(row, rows) <= significance_level;
  }
}

double least_p_of(const PairedRow& row, const std::vector<PairedRow>& rows) {
  return smallest_corrected_p(row.paired.difference.count, family_of(row, rows));
}

Columns<PairedRow> paired_columns() {
  using Row = PairedRow;
  const auto six_digits = [](std::optional<double> p) {
    return p ? fmt::format("{:.6g}", *p) : "";
  };
  Columns<Row> columns;
  columns.field("seeds", [](const Row& row) { return count_cell(row.paired.difference.count); })
      .field("mean_difference", [](const Row& row) { return mean_cell(row.paired.difference); })
      .field("ci95_low", [](const Row& row) { return interval_cell(row.paired.difference); })
      .field("ci95_high",
             [](const Row& row) {
               const auto& interval = row.paired.difference.interval;
               return interval ? four_decimals(interval->high) : "";
             })
      .field("rank_biserial",
             [](const Row& row) {
               return is_tested(row) ? four_decimals(row.paired.rank_biserial) : "";
             })
      .field("p", [=](const Row& row) { return six_digits(row.paired.p); })
      .field("p_holm", [=](const Row& row) { return six_digits(row.p_holm); });
  return columns;
}

std::vector<std::vector<const PairedRow*>> blocks_of(const std::vector<PairedRow>& rows) {
  std::vector<std::vector<const PairedRow*>> blocks;
  for (const PairedRow& row : rows) {
    const auto same = std::ranges::find_if(
        blocks, [&](const auto& block) { return block.front()->method == row.method; });
    (same == blocks.end() ? blocks.emplace_back() : *same).push_back(&row);
  }
  return blocks;
}

std::string block_label(const std::vector<const PairedRow*>& block,
                        const std::vector<PairedRow>& rows) {
  const auto count = [](const PairedRow& row) { return row.paired.difference.count; };
  const std::size_t most = count(*std::ranges::max_element(rows, {}, count));
  const bool fewer =
      std::ranges::any_of(block, [&](const PairedRow* row) { return count(*row) < most; });
  return marked_if(fewer, method_label(block.front()->method));
}

text::Table paired_table(const std::vector<PairedRow>& rows) {
  const bool intervals = std::ranges::any_of(rows, has_an_interval);
  const bool tests = std::ranges::any_of(rows, is_tested);
  std::vector<std::string> headings{"method", "ratio", "difference"};
  if (intervals) headings.emplace_back("95 % interval");
  if (tests) headings.insert(headings.end(), {"effect", "p (Holm)"});
  text::Table table(headings, 2);
  for (const std::vector<const PairedRow*>& block : blocks_of(rows)) {
    std::string name = block_label(block, rows);
    for (const PairedRow* const row : block) {
      const scoring::Summary& difference = row->paired.difference;
      text::Cells cells{name, row->ratio_label, mean_cell(difference, difference_style)};
      if (intervals) cells.push_back(interval_cell(difference, difference_style));
      if (tests) cells.insert(cells.end(), {effect_label(*row), p_label(*row)});
      table.row(std::move(cells));
      name.clear();
    }
  }
  return table;
}

std::string paired_note(const std::vector<PairedRow>& rows, const std::string& about_means) {
  if (std::ranges::none_of(rows, is_tested)) {
    return "Differences in points. A single seed cannot be tested.";
  }
  return std::string("Differences in points, paired by seed: mean ± standard deviation") +
         (std::ranges::any_of(rows, has_an_interval) ? ", and the interval of the mean" : "") +
         ". Effect: matched-pairs rank-biserial correlation, +1 where every difference is "
         "positive, "
         "-1 where every one is negative. p: Wilcoxon's signed-rank test, two-sided and exact, "
         "differences of zero left out; in brackets with Holm's correction over the methods at the "
         "same ratio, without ceilings. " +
         about_means + warning_of_few_seeds(rows);
}

}  // namespace piae::report
