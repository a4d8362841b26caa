#include "report/significance.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

/// What the project is about, the newer one first.
constexpr const char* subjects[] = {"piae-dt-phase", "piae-dt"};

std::string choose_reference(const std::vector<std::string>& methods, const std::string& asked) {
  const auto has = [&](const std::string& method) {
    return std::ranges::count(methods, method) > 0;
  };
  if (!asked.empty() && !has(asked)) {
    std::string known;
    for (const std::string& method : methods) known += ' ' + method;
    throw Error(Exit::usage,
                "--against " + asked + ": has no cell here; methods that have:" + known);
  }
  if (!asked.empty()) return asked;
  const auto* const subject = std::ranges::find_if(subjects, has);
  return subject == std::end(subjects) ? "" : *subject;
}

}  // namespace

Comparisons compare_methods(const std::vector<AccuracyRow>& rows, const std::string& against) {
  const std::vector<std::string> methods = methods_of(rows);
  Comparisons comparisons{rows.front().dataset, choose_reference(methods, against), {}};
  const std::vector<AccuracyRow> all = with_means(rows);
  for (const std::string& method : methods) {
    if (method == comparisons.against) continue;
    for (const RatioColumn& column : compared_columns(all)) {
      const AccuracyRow* row = find_row(all, method, column.ratio);
      const AccuracyRow* other = find_row(all, comparisons.against, column.ratio);
      if (row != nullptr && other != nullptr) {
        comparisons.rows.push_back(pair(*row, column.ratio, *other));
      }
    }
  }
  correct(comparisons.rows);
  return comparisons;
}

std::string comparisons_csv(const Comparisons& comparisons) {
  const auto line = [](std::vector<std::string> first, const std::vector<std::string>& rest) {
    first.insert(first.end(), rest.begin(), rest.end());
    return text::csv_line(first);
  };
  std::string text = line({"dataset", "ratio", "method", "against"}, paired_header());
  for (const PairedRow& row : comparisons.rows) {
    text +=
        line({comparisons.dataset, row.ratio, row.method, comparisons.against}, paired_fields(row));
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
    add_paired(table, method_label(method), method, comparisons.rows, columns);
  }
  return {{"comparisons",
           "Accuracy minus that of " + method_label(comparisons.against) + " on " +
               comparisons.dataset + PaperReference(comparisons.dataset).none(),
           paired_note(comparisons.rows), table}};
}

}  // namespace piae::report
