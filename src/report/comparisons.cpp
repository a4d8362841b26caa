#include "report/comparisons.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "report/csv_fields.hpp"
#include "report/labels.hpp"
#include "report/paper_methods.hpp"
#include "report/paper_reference.hpp"

namespace piae::report {

namespace {

/// The method that all others are compared with where none is asked for: this project's, or else
/// the paper's; empty where neither is there.
std::string method_of_interest(const std::vector<std::string>& methods) {
  const auto is_there = [&](const augment::CatalogueEntry& entry) {
    return std::ranges::count(methods, entry.name) > 0;
  };
  for (const augment::CatalogueEntry& entry : augment::catalogue()) {
    if (entry.kind == augment::Kind::ours && is_there(entry)) return entry.name;
  }
  return std::ranges::count(methods, paper_method()) > 0 ? paper_method() : "";
}

std::string choose_other_side(const std::vector<std::string>& methods, const std::string& asked) {
  if (asked.empty()) return method_of_interest(methods);
  if (std::ranges::count(methods, asked) > 0) return asked;
  std::string known;
  for (const std::string& method : methods) known += ' ' + method;
  throw Error(Exit::usage, "--against " + asked + ": has no cell here; methods that have:" + known);
}

}  // namespace

Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against) {
  const std::vector<std::string> methods = methods_of(rows);
  Comparisons comparisons{.dataset = rows.front().dataset,
                          .against = choose_other_side(methods, against)};
  const std::vector<AccuracyRow> all = with_means(rows);
  for (const std::string& method : methods) {
    if (method == comparisons.against) continue;
    for (const RatioColumn& column : compared_columns(all)) {
      const AccuracyRow* row = find_row(all, method, column.ratio);
      const AccuracyRow* other = find_row(all, comparisons.against, column.ratio);
      if (row != nullptr && other != nullptr) {
        comparisons.rows.push_back(paired_row(*row, column.ratio, *other));
      }
    }
  }
  add_holm_p(comparisons.rows);
  return comparisons;
}

std::string comparisons_csv(const Comparisons& comparisons) {
  std::string text = joined_csv_line({{"dataset", "ratio", "method", "against"}, paired_header()});
  for (const PairedRow& row : comparisons.rows) {
    text += joined_csv_line(
        {{comparisons.dataset, row.ratio, row.method, comparisons.against}, paired_fields(row)});
  }
  return text;
}

std::vector<Section> comparison_sections(const Comparisons& comparisons,
                                         const std::vector<AccuracyRow>& rows) {
  if (comparisons.rows.empty()) return {};
  const std::vector<RatioColumn> columns = compared_columns(with_means(rows));
  std::vector<std::string> header{"method", ""};
  for (const RatioColumn& column : columns) header.push_back(column.label);
  text::Table table(header, 2);
  for (const std::string& method : methods_of(rows)) {
    if (method == comparisons.against) continue;
    add_paired_lines(table, method_label(method), method, comparisons.rows, columns);
  }
  return {{.key = "comparisons",
           .title = "Accuracy minus that of " + method_label(comparisons.against) + " on " +
                    comparisons.dataset + PaperReference(comparisons.dataset).none(),
           .note = paired_note(comparisons.rows),
           .table = table}};
}

}  // namespace piae::report
