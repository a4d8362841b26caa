#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "report/classifier_rows.hpp"
#include "report/csv_fields.hpp"
#include "report/transfer_tables.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

using Fields = std::vector<std::string>;

const std::string over_seeds = "mean";

std::string role_of(const TransferGroup& group, const GroupRow& row) {
  if (row.method == group.choices.against) return "against";
  if (augment::is_ceiling(row.method)) return "ceiling";
  return &row == group.bar() ? "bar" : "method";
}

std::string yes_or_no(bool yes) { return yes ? "1" : "0"; }

Fields summary_fields(const std::optional<scoring::Summary>& summary) {
  if (!summary) return {"", "", "", ""};
  Fields fields = mean_fields(*summary);
  for (std::string& end : interval_fields(*summary)) fields.push_back(std::move(end));
  return fields;
}

/// One seed of a cell: no spread.
Fields value_fields(const std::optional<AccuracyRow>& row, std::size_t seed) {
  return {row ? four_decimals(row->values[seed]) : "", "", "", ""};
}

/// The lines of a cell, which all begin and end with the same fields: each seed, and the mean over
/// them.
std::string cell_lines(const Fields& first, const GroupCell& cell, const Fields& last) {
  std::string lines;
  for (std::size_t i = 0; i < cell.row.seeds.size(); ++i) {
    lines += joined_csv_line({first,
                              {std::to_string(cell.row.seeds[i])},
                              value_fields(cell.row, i),
                              value_fields(cell.kind, i),
                              last});
  }
  const auto kind = cell.kind ? std::optional(cell.kind->summary) : std::nullopt;
  return lines +
         joined_csv_line(
             {first, {over_seeds}, summary_fields(cell.row.summary), summary_fields(kind), last});
}

std::string row_lines(const TransferGroup& group, const GroupRow& row) {
  const auto lines = [&](const GroupCell& cell) {
    return cell_lines({cell.row.dataset, four_decimals(cell.row.speed_ratio), row.method,
                       role_of(group, row), row.classifier, yes_or_no(row.by_class.recorded),
                       yes_or_no(row.by_class.best), row.mean.row.ratio},
                      cell, {yes_or_no(row.by_kind.recorded), yes_or_no(row.by_kind.best)});
  };
  std::string text;
  for (const GroupCell& cell : row.datasets) text += lines(cell);
  return text + lines(row.mean);
}

}  // namespace

std::string transfer_csv(const TransferGroup& group) {
  std::string text =
      text::csv_line({"dataset", "speed_ratio", "method", "role", "classifier", "recorded", "best",
                      "ratio", "seed", "accuracy", "std", "ci95_low", "ci95_high", "kind",
                      "kind_std", "kind_ci95_low", "kind_ci95_high", "kind_recorded", "kind_best"});
  for (const GroupRow& row : group.rows) text += row_lines(group, row);
  return text;
}

std::string transfer_comparisons_csv(const TransferGroup& group) {
  std::string text = joined_csv_line(
      {{"group", "ratio", "method", "classifier", "minus", "minus_classifier"}, paired_header()});
  const std::vector<const GroupRow*> others = group.others();
  for (std::size_t i = 0; i < group.differences.size(); ++i) {
    const PairedRow& row = group.differences[i];
    text += joined_csv_line({{group.choices.group, row.ratio, group.own()->method,
                              group.own()->classifier, others[i]->method, others[i]->classifier},
                             paired_fields(row)});
  }
  return text;
}

}  // namespace piae::report
