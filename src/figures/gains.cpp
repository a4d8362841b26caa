#include "figures/gains.hpp"

#include <algorithm>
#include <optional>

#include "augment/catalogue.hpp"
#include "figures/groups.hpp"
#include "figures/intervals.hpp"
#include "report/paper.hpp"

namespace piae::figures {

namespace {

using report::AccuracyRow;

std::string or_empty(std::optional<double> number) { return number ? digits(*number) : ""; }

void add_gain(Numbers& numbers, const AccuracyRow& row, const std::string& paper_dataset) {
  const std::string ceiling = augment::is_ceiling(row.method) ? "1" : "0";
  const std::string generated = std::to_string(row.generated_per_class);
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    numbers.row({row.method, ceiling, row.ratio, generated, std::to_string(row.seeds[i]),
                 digits(row.values[i]), "", "", "", ""});
  }
  const std::vector<std::string> interval = shown_interval(row.summary);
  const auto published = row.published ? row.published : row.orientation;
  numbers.row({row.method, ceiling, row.ratio, generated, "mean", digits(row.summary.mean),
               interval[0], interval[1], or_empty(published), published ? paper_dataset : ""});
}

Numbers gain_numbers(const std::vector<AccuracyRow>& rows, const std::string& what) {
  Numbers numbers({"method", "ceiling", "ratio", "generated_per_class", "seed", what, "low", "high",
                   "published", "published_of"});
  for (const AccuracyRow& row : rows) {
    const auto counterpart = report::PaperReference(row.dataset).counterpart();
    add_gain(numbers, row, counterpart ? counterpart->paper.title : "");
  }
  return numbers;
}

Numbers gains_of(const report::ClassifierRows& shown, Group group) {
  const std::vector<std::string> methods = methods_among(report::methods_of(shown.rows), group);
  std::vector<AccuracyRow> rows = report::gain_rows(shown.rows);
  if (rows.empty()) throw LeftOut("the run has no cell of the method none");
  std::erase_if(rows, [&](const AccuracyRow& row) {
    return std::ranges::find(methods, row.method) == methods.end() &&
           !augment::is_ceiling(row.method);
  });
  if (rows.empty()) throw LeftOut("the run has no method other than none to show");
  return gain_numbers(rows, "gain");
}

}  // namespace

Numbers gains_of_methods(Source& /*source*/, const report::ClassifierRows& shown) {
  return gains_of(shown, Group::methods);
}

Numbers gains_of_models(Source& /*source*/, const report::ClassifierRows& shown) {
  return gains_of(shown, Group::models);
}

Numbers accuracies(Source& /*source*/, const report::ClassifierRows& shown) {
  std::vector<AccuracyRow> rows = shown.rows;
  if (shown.reference_row) {
    rows.push_back(*shown.reference_row);
    rows.back().method = shown.reference_row->classifier;
  }
  return gain_numbers(rows, "accuracy");
}

}  // namespace piae::figures
