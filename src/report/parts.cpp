#include "report/parts.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/columns.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"

namespace piae::report {

namespace {

constexpr NumberStyle one_decimal{.decimals = 1};
constexpr NumberStyle one_decimal_signed{.decimals = 1, .sign = true};

bool is_the_method(const SweepRow& row) { return row.point.factor.empty(); }

bool has_fault_types(const PartRow& row) { return row.moved.accuracy.type_accuracy.has_value(); }

std::vector<SweepRow> moved_rows(const std::vector<PartRow>& rows) {
  std::vector<SweepRow> moved;
  for (const PartRow& row : rows) moved.push_back(row.moved);
  return moved;
}

std::optional<scoring::Summary> difference_of(const PartRow& row) {
  return row.difference ? std::optional(row.difference->paired.difference) : std::nullopt;
}

std::string setting_label(const SweepPoint& point) {
  if (point.factor.empty()) return "as in the grid";
  return point.factor + "=" + point.value + (point.centre ? " (as in the grid)" : "");
}

/// Returns a row for each setting. Marks settings with fewer than `most` seeds.
text::Table ratio_table(const std::vector<PartRow>& rows, std::size_t most) {
  const bool types = std::ranges::any_of(rows, has_fault_types);
  std::vector<std::string> header{"setting", "accuracy", "95 % interval"};
  if (types) header.emplace_back("by fault type");
  header.insert(header.end(), {"difference", "95 % interval"});
  text::Table table(header, 1);
  for (const PartRow& row : rows) {
    const AccuracyRow& accuracy = row.moved.accuracy;
    std::vector<std::string> cells{
        marked_if(accuracy.seeds.size() < most, setting_label(row.moved.point)),
        mean_label(accuracy.summary, one_decimal), interval_label(accuracy.summary, one_decimal)};
    if (types) cells.push_back(mean_label(*accuracy.type_accuracy, one_decimal));
    if (row.difference) {
      const scoring::Summary& difference = row.difference->paired.difference;
      cells.push_back(mean_label(difference, one_decimal_signed));
      cells.push_back(interval_label(difference, one_decimal_signed));
    }
    table.row(cells);
  }
  return table;
}

/// Returns the rows of each ratio, in the order of Table 5.
std::vector<std::vector<PartRow>> by_ratio(const std::vector<PartRow>& rows) {
  std::vector<std::vector<PartRow>> blocks;
  for (const scoring::Ratio& ratio : scoring::all_ratios()) {
    std::vector<PartRow> block;
    std::ranges::copy_if(rows, std::back_inserter(block), [&](const PartRow& row) {
      return row.moved.accuracy.ratio == ratio.name;
    });
    if (!block.empty()) blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace

std::vector<PartRow> part_rows(const std::vector<SweepRow>& rows) {
  std::vector<PartRow> parts;
  for (const SweepRow& row : rows) {
    const auto whole = std::ranges::find_if(rows, [&](const SweepRow& other) {
      return is_the_method(other) && other.accuracy.ratio == row.accuracy.ratio;
    });
    PartRow part{.moved = row, .difference = std::nullopt};
    if (!row.point.centre && whole != rows.end()) {
      part.difference = paired_row(row.accuracy, whole->accuracy);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

std::string parts_csv(const Sweep& sweep, const std::vector<PartRow>& rows) {
  using Row = PartRow;
  const auto pairs = [](const Row& row) {
    return count_cell(difference_of(row).value_or(scoring::Summary()).count);
  };
  Columns<Row> columns;
  columns.field("dataset", [&](const Row&) { return sweep.grid.dataset; })
      .field("method", [&](const Row&) { return sweep.method; })
      .field("classifier", [&](const Row&) { return sweep.classifier; })
      .field("factor", [](const Row& row) { return row.moved.point.factor; })
      .field("value", [](const Row& row) { return row.moved.point.value; })
      .field("centre", [](const Row& row) { return row.moved.point.centre ? "1" : "0"; })
      .field("ratio", [](const Row& row) { return row.moved.accuracy.ratio; })
      .field("seeds", [](const Row& row) { return count_cell(row.moved.accuracy.summary.count); })
      .summary_fields("mean", "", [](const Row& row) { return row.moved.accuracy.summary; })
      .field("pairs", pairs)
      .summary_fields("difference", "difference_", difference_of);
  if (std::ranges::any_of(rows, has_fault_types)) {
    columns.summary_fields("kind_mean", "kind_",
                           [](const Row& row) { return row.moved.accuracy.type_accuracy; });
  }
  return columns.table(rows).csv();
}

Document parts_document(const Sweep& sweep, const std::vector<PartRow>& rows,
                        const run::Results& results) {
  Document document{
      .key = sweep.grid.dataset + "-" + run::sweep_name(sweep.method),
      .title = "Effect of each part of " + sweep.method + " on " + sweep.grid.dataset};
  const std::vector<std::int64_t> seeds = seeds_of_any_row(moved_rows(rows));
  const bool types = std::ranges::any_of(rows, has_fault_types);
  document.paragraphs.push_back(fmt::format(
      "Accuracy in percent by {}, with one setting of {} moved and all others as in the grid. The "
      "difference from the method as in the grid is in points and paired by seed: a negative one "
      "means that the method is worse without that part. {}Split protocol {}; {} ({}). "
      "Numbers are the mean ± the sample standard deviation over the seeds. {}",
      diagnosis::marked_name(sweep.classifier), sweep.method,
      types ? "By fault type: a window counts as correct if the damaged part of the bearing is "
              "named, "
              "whatever the size of the defect. "
            : "",
      to_string(results.diagnoses.front().protocol), counted(seeds.size(), "seed"),
      seed_list(seeds), about_intervals));
  for (const std::vector<PartRow>& block : by_ratio(rows)) {
    const AccuracyRow& first = block.front().moved.accuracy;
    const std::vector<SweepRow> of_ratio = moved_rows(block);
    const std::size_t most = seeds_of_any_row(of_ratio).size();
    document.sections.push_back({.key = first.ratio,
                                 .title = "At " + ratio_label(first.ratio, first.true_ratio),
                                 .note = fewer_seeds_note(of_ratio, most),
                                 .table = ratio_table(block, most)});
  }
  return document;
}

}  // namespace piae::report
