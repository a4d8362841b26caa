#include "report/paired_rows.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <functional>
#include <set>

#include "report/csv_fields.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

using Cells = std::vector<std::string>;
using LabelOf = std::function<std::string(const PairedRow&)>;

constexpr NumberStyle difference_style{.decimals = 2, .sign = true};

std::string p_label(const PairedRow& row) {
  if (!row.paired.p) return "";
  return fmt::format("{:.3g} ({:.3g})", *row.paired.p, *row.p_holm);
}

std::string effect_label(const PairedRow& row) {
  return row.paired.p ? number_label(row.paired.rank_biserial, difference_style) : "";
}

/// The largest number of methods that are compared at one ratio.
std::size_t largest_family(const std::vector<PairedRow>& rows) {
  std::size_t largest = 0;
  for (const PairedRow& row : rows) {
    const auto size = std::ranges::count(rows, row.ratio, &PairedRow::ratio);
    largest = std::max(largest, static_cast<std::size_t>(size));
  }
  return largest;
}

/// A warning where even the smallest p that so few seeds can give is not below the usual level.
std::string warning_of_few_seeds(std::size_t seeds, std::size_t methods) {
  constexpr double level = 0.05;
  const double smallest = scoring::smallest_p(seeds);
  const double corrected = std::min(1.0, smallest * static_cast<double>(methods));
  if (corrected <= level) return "";
  std::string text =
      fmt::format(" Mind that {} seeds cannot give a p below {:.3g}", seeds, smallest);
  if (methods > 1)
    text += fmt::format(", which Holm's correction for {} makes {:.3g}", methods, corrected);
  return text + ": however large a difference is, it cannot be significant at 0.05 here.";
}

}  // namespace

PairedRow paired_row(const AccuracyRow& row, const std::string& ratio, const AccuracyRow& other) {
  return {.method = row.method,
          .ratio = ratio,
          .paired = scoring::paired_difference(row.values, other.values),
          .p_holm = std::nullopt};
}

void add_holm_p(std::vector<PairedRow>& rows) {
  std::set<std::string> ratios;
  for (const PairedRow& row : rows) ratios.insert(row.ratio);
  for (const std::string& ratio : ratios) {
    std::vector<PairedRow*> family;
    std::vector<double> p;
    for (PairedRow& row : rows) {
      if (row.ratio != ratio || !row.paired.p) continue;
      family.push_back(&row);
      p.push_back(*row.paired.p);
    }
    const std::vector<double> corrected = scoring::holm(p);
    for (std::size_t i = 0; i < family.size(); ++i) family[i]->p_holm = corrected[i];
  }
}

Cells paired_header() {
  return {"seeds", "mean_difference", "ci95_low", "ci95_high", "rank_biserial", "p", "p_holm"};
}

Cells paired_fields(const PairedRow& row) {
  const scoring::Summary& difference = row.paired.difference;
  Cells fields{std::to_string(difference.count), four_decimals(difference.mean)};
  if (!row.paired.p) return {fields[0], fields[1], "", "", "", "", ""};
  fields.push_back(four_decimals(difference.interval->low));
  fields.push_back(four_decimals(difference.interval->high));
  fields.push_back(four_decimals(row.paired.rank_biserial));
  fields.push_back(fmt::format("{:.6g}", *row.paired.p));
  fields.push_back(fmt::format("{:.6g}", *row.p_holm));
  return fields;
}

void add_paired_lines(text::Table& table, const std::string& name, const std::string& method,
                      const std::vector<PairedRow>& rows, const std::vector<RatioColumn>& columns) {
  const auto line = [&](const std::string& first, const std::string& what, const LabelOf& label) {
    Cells cells{first, what};
    for (const RatioColumn& column : columns) {
      const auto row = std::ranges::find_if(rows, [&](const PairedRow& each) {
        return each.method == method && each.ratio == column.ratio;
      });
      cells.push_back(row == rows.end() ? "" : label(*row));
    }
    return cells;
  };
  table.row(line(name, "difference", [](const PairedRow& row) {
    return mean_label(row.paired.difference, difference_style);
  }));
  const bool is_tested =
      std::ranges::any_of(rows, [](const PairedRow& row) { return row.paired.p.has_value(); });
  if (!is_tested) return;
  table.row(line("", "95 %", [](const PairedRow& row) {
    return interval_label(row.paired.difference, difference_style);
  }));
  table.row(line("", "effect", effect_label));
  table.row(line("", "p (Holm)", p_label));
}

std::string paired_note(const std::vector<PairedRow>& rows) {
  const std::size_t seeds = rows.front().paired.difference.count;
  if (seeds == 1) return "Differences in points. One seed alone can be tested for nothing.";
  return "Differences in points, paired by seed: mean ± standard deviation, and the interval of "
         "the "
         "mean. Effect: matched-pairs rank-biserial correlation, +1 where every difference is "
         "positive, -1 where every one is negative. p: Wilcoxon's signed-rank test, two-sided and "
         "exact, differences of zero left out; in brackets with Holm's correction over the methods "
         "of the same column. The mean of ratios is taken for each seed, since ratios of one seed "
         "share their split and are no independent repeats." +
         warning_of_few_seeds(seeds, largest_family(rows));
}

}  // namespace piae::report
