#include "report/accuracy_columns.hpp"

#include <spdlog/fmt/fmt.h>

namespace piae::report {

namespace {

using Row = AccuracyRow;
using Style = NumberStyle;

std::optional<double> high(const scoring::Summary& summary) {
  return summary.interval ? std::optional(summary.interval->high) : std::nullopt;
}

text::Cell published(const Row& row, Style /*style*/) {
  return row.published ? fmt::format("{:g}", *row.published) : "";
}

text::Cell theirs(const Row& row, Style style) {
  return row.theirs() ? number_cell(*row.theirs(), style) : "";
}

const AccuracyColumn columns[] = {
    {.field = "generated_per_class",
     .terminal = "generated",
     .cell = [](const Row& row,
                Style) { return text::Cell(std::to_string(row.generated_per_class)); }},
    {.field = "seeds",
     .terminal = "seeds",
     .cell = [](const Row& row, Style) { return count_cell(row.summary.count); }},
    {.field = "mean",
     .terminal = "accuracy %",
     .heading = "here",
     .cell = [](const Row& row, Style style) { return mean_cell(row.summary, style); }},
    {.field = "std",
     .cell = [](const Row& row,
                Style) { return text::Cell(four_decimals(row.summary.deviation)); }},
    {.field = "ci95_low",
     .terminal = "95 % interval",
     .heading = "95 % interval",
     .cell = [](const Row& row, Style style) { return interval_cell(row.summary, style); }},
    {.field = "ci95_high",
     .cell = [](const Row& row, Style) { return text::Cell(four_decimals(high(row.summary))); }},
    {.field = "published", .cell = published},
    {.terminal = "paper", .types = false, .cell = published},
    {.heading = "paper", .cell = theirs},
    {.field = "kind_mean",
     .terminal = "type %",
     .heading = "fault type",
     .types = true,
     .cell = [](const Row& row, Style style) { return mean_cell(*row.type_accuracy, style); }},
    {.field = "kind_std",
     .types = true,
     .cell = [](const Row& row,
                Style) { return text::Cell(four_decimals(row.type_accuracy->deviation)); }},
    {.field = "kind_ci95_low",
     .types = true,
     .cell = [](const Row& row, Style) { return interval_cell(*row.type_accuracy); }},
    {.field = "kind_ci95_high",
     .types = true,
     .cell = [](const Row& row,
                Style) { return text::Cell(four_decimals(high(*row.type_accuracy))); }},
};

}  // namespace

std::span<const AccuracyColumn> accuracy_columns() { return columns; }

}  // namespace piae::report
