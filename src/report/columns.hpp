#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "report/labels.hpp"
#include "scoring/recall.hpp"
#include "text/table.hpp"

namespace piae::report {

/// Returns a number that people see as this label and by which a page sorts.
text::Cell labelled_cell(double number, const std::string& label);
/// Returns a number as a table shows it; with four decimals in CSV.
text::Cell number_cell(double number, NumberStyle style = {});
text::Cell count_cell(std::size_t count);
/// Returns "85.40 ± 1.20", sorted by the mean.
text::Cell mean_cell(const scoring::Summary& summary, NumberStyle style = {});
/// Returns "[84.01, 86.79]"; in CSV the lower end.
text::Cell interval_cell(const scoring::Summary& summary, NumberStyle style = {});
/// Returns a share of windows in percent, or no_number for an empty share. The source of the cell
/// is "3 of 4 windows".
text::Cell share_cell(const scoring::Share& share);
/// Returns the share of windows that were recognised. A page shades lower shares more strongly.
text::Cell recall_cell(const scoring::Share& share);

/// Columns of a table with rows of type `Of`, defined once for all formats. A cell is a function of
/// a row or one of its members.
template <class Of>
class Columns {
 public:
  using CellOf = std::function<text::Cell(const Of&)>;
  using SummaryOf = std::function<std::optional<scoring::Summary>(const Of&)>;

  Columns& add(text::Column column, CellOf cell_of) {
    columns_.emplace_back(std::move(column), std::move(cell_of));
    return *this;
  }
  /// Adds a column for people; also for CSV if `field` names it.
  Columns& words(const std::string& heading, CellOf cell_of, const std::string& field = "") {
    return add({.heading = heading, .field = field}, std::move(cell_of));
  }
  Columns& numbers(const std::string& heading, CellOf cell_of, const std::string& field = "") {
    return add({.heading = heading, .is_number = true, .field = field}, std::move(cell_of));
  }
  /// Adds a column that only CSV has.
  Columns& field(const std::string& name, CellOf cell_of) {
    return add({.heading = name, .field = name, .shown = text::Shown::in_csv}, std::move(cell_of));
  }
  /// Adds dataset, method, classifier and ratio of `row_of(row)`; only CSV has them.
  template <class RowOf>
  Columns& name_fields(RowOf row_of) {
    return field("dataset", [=](const Of& of) { return std::invoke(row_of, of).dataset; })
        .field("method", [=](const Of& of) { return std::invoke(row_of, of).method; })
        .field("classifier", [=](const Of& of) { return std::invoke(row_of, of).classifier; })
        .field("ratio", [=](const Of& of) { return std::invoke(row_of, of).ratio; });
  }
  /// Adds the mean and the standard deviation, and the ends of the interval if `intervals`. Only
  /// CSV has them. `before` is the prefix of the names "std", "ci95_low" and "ci95_high". Missing
  /// numbers are empty.
  Columns& summary_fields(const std::string& mean, const std::string& before,
                          const SummaryOf& summary_of, bool intervals = true) {
    const auto add_field = [&](const std::string& name, auto part) {
      field(name, [summary_of, part](const Of& row) {
        const auto summary = summary_of(row);
        return text::Cell(summary ? four_decimals(part(*summary)) : "");
      });
    };
    using scoring::Summary;
    add_field(mean, [](const Summary& s) { return std::optional(s.mean); });
    add_field(before + "std", [](const Summary& s) { return s.deviation; });
    if (!intervals) return *this;
    add_field(before + "ci95_low", [](const Summary& s) {
      return s.interval ? std::optional(s.interval->low) : std::nullopt;
    });
    add_field(before + "ci95_high", [](const Summary& s) {
      return s.interval ? std::optional(s.interval->high) : std::nullopt;
    });
    return *this;
  }

  /// Adds the columns of a part of each row.
  template <class Part, class PartOf>
  Columns& with(const Columns<Part>& others, PartOf part_of) {
    for (const auto& other : others.columns_) {
      const auto& cell_of = other.second;
      add(other.first,
          [cell_of, part_of](const Of& row) { return cell_of(std::invoke(part_of, row)); });
    }
    return *this;
  }

  [[nodiscard]] text::Table table(const std::vector<Of>& rows) const {
    text::Table table;
    for (const auto& [column, cell_of] : columns_) table.column(column);
    for (const Of& row : rows) {
      text::Cells cells;
      for (const auto& [column, cell_of] : columns_) cells.push_back(cell_of(row));
      table.row(std::move(cells));
    }
    return table;
  }

 private:
  template <class Other>
  friend class Columns;

  std::vector<std::pair<text::Column, CellOf>> columns_;
};

}  // namespace piae::report
