#include "figures/gains.hpp"

#include <algorithm>
#include <optional>

#include "augment/catalogue.hpp"
#include "figures/groups.hpp"
#include "figures/intervals.hpp"
#include "report/paper_reference.hpp"

namespace piae::figures {

namespace {

using report::AccuracyRow;

std::string or_empty(std::optional<double> number) { return number ? digits(*number) : ""; }

void add_row(Numbers& numbers, const AccuracyRow& row, const std::string& paper_dataset) {
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

Numbers numbers_of(Source& source, const std::vector<AccuracyRow>& rows, const std::string& what) {
  Numbers numbers({"method", "ceiling", "ratio", "generated_per_class", "seed", what, "low", "high",
                   "published", "published_of"});
  const auto beside = report::PaperReference(source.grid().dataset).beside();
  for (const AccuracyRow& row : rows) add_row(numbers, row, beside ? beside->paper.title : "");
  return numbers;
}

Numbers gains_of(Source& source, const std::vector<std::string>& methods) {
  std::vector<AccuracyRow> rows = report::gain_rows(source.accuracy_rows());
  if (rows.empty()) throw LeftOut("the run has no cell of the method none");
  std::erase_if(rows, [&](const AccuracyRow& row) {
    return std::ranges::find(methods, row.method) == methods.end() &&
           !augment::is_ceiling(row.method);
  });
  return numbers_of(source, rows, "gain");
}

}  // namespace

Numbers gains_of_methods(Source& source) {
  return gains_of(source, methods_in(source.grid(), Group::methods));
}

Numbers gains_of_models(Source& source) {
  return gains_of(source, methods_in(source.grid(), Group::models));
}

Numbers accuracies(Source& source) {
  return numbers_of(source, source.accuracy_rows(), "accuracy");
}

}  // namespace piae::figures
