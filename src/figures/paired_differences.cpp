#include "figures/paired_differences.hpp"

#include <algorithm>
#include <optional>

#include "augment/catalogue.hpp"
#include "figures/intervals.hpp"
#include "report/comparisons.hpp"

namespace piae::figures {

namespace {

using report::PairedRow;

/// A method compared with another at one ratio; its rows start with these fields.
struct Comparison {
  PairedRow paired;
  std::vector<std::string> fields;
};

void add_mean(Numbers& numbers, const Comparison& comparison, double least_p) {
  const PairedRow& row = comparison.paired;
  const std::vector<std::string> interval = shown_interval(row.paired.difference);
  std::vector<std::string> fields = comparison.fields;
  fields.insert(fields.end(),
                {"mean", digits(row.paired.difference.mean), interval[0], interval[1]});
  if (row.paired.p) {
    fields.insert(fields.end(),
                  {digits(*row.paired.p), row.p_holm ? digits(*row.p_holm) : "", digits(least_p)});
  } else {
    fields.insert(fields.end(), {"", "", ""});
  }
  numbers.row(fields);
}

void add_seeds(Numbers& numbers, const Comparison& comparison) {
  const PairedRow& row = comparison.paired;
  for (std::size_t i = 0; i < row.seeds.size(); ++i) {
    std::vector<std::string> fields = comparison.fields;
    fields.insert(fields.end(),
                  {std::to_string(row.seeds[i]), digits(row.differences[i]), "", "", "", "", ""});
    numbers.row(fields);
  }
}

}  // namespace

Numbers paired_differences(Source& /*source*/, const report::ClassifierRows& shown) {
  const report::Comparisons comparisons = report::compare_methods(shown.rows, "");
  if (comparisons.rows.empty()) {
    throw LeftOut("the run has neither " + augment::paper_method() +
                  " nor a method of this project to compare with others");
  }
  const std::string& against = comparisons.against;
  Numbers numbers({"method", "ceiling", "ratio", "against", "seed", "difference", "low", "high",
                   "p", "p_holm", "least_p"});
  for (const PairedRow& paired : comparisons.rows) {
    const std::string ceiling = augment::is_ceiling(paired.method) ? "1" : "0";
    const Comparison comparison{paired, {paired.method, ceiling, paired.ratio, against}};
    add_seeds(numbers, comparison);
    add_mean(numbers, comparison, report::least_p_of(paired, comparisons.rows));
  }
  return numbers;
}

}  // namespace piae::figures
