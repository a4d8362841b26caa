#include "figures/protocols.hpp"

#include "augment/catalogue.hpp"
#include "figures/intervals.hpp"
#include "run/held.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::figures {

namespace {

/// Returns the accuracies of one run for the cells that both runs have.
std::vector<report::AccuracyRow> rows_of_side(const run::Layout& side, const run::Layout& other,
                                              const std::string& dataset) {
  const run::Grid nothing_requested{
      .dataset = dataset, .scored = {}, .combinations = {}, .seeds = {}};
  const auto [grid, results] = run::collect_held_diagnoses(
      side, nothing_requested, run::Held(side, other, {}), run::Classifiers::papers);
  require_whole(results);
  return report::accuracy_rows(grid, results, report::Published());
}

/// Returns the protocol of a run, read from one cell.
std::string protocol_of(const run::Layout& side, const report::AccuracyRow& row) {
  const artefact::Reader cell(side.diagnosis(row.method, row.ratio, row.seeds.front()),
                              "diagnosis");
  return to_string(scoring::read_diagnosis(cell).protocol);
}

void add_side(Numbers& numbers, const std::vector<report::AccuracyRow>& rows,
              const std::string& protocol) {
  for (const report::AccuracyRow& row : rows) {
    const std::string ceiling = augment::is_ceiling(row.method) ? "1" : "0";
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      numbers.row({row.method, ceiling, row.ratio, protocol, std::to_string(row.seeds[i]),
                   digits(row.values[i]), "", ""});
    }
    const std::vector<std::string> interval = shown_interval(row.summary);
    numbers.row({row.method, ceiling, row.ratio, protocol, "mean", digits(row.summary.mean),
                 interval[0], interval[1]});
  }
}

}  // namespace

Numbers protocols(Source& source) {
  const run::Layout& here = source.layout();
  const run::Layout counterpart = here.blocked();
  const auto rows = rows_of_side(here, counterpart, source.grid().dataset);
  if (rows.empty()) {
    throw LeftOut("the run with the other split is missing; run `make contrast`");
  }
  const std::string own = protocol_of(here, rows.front());
  const std::string other = protocol_of(counterpart, rows.front());
  if (own == other) {
    throw Error(Exit::bad_input, counterpart.folder().string() + ": its split is " + other +
                                     ", like that of the run itself");
  }
  Numbers numbers({"method", "ceiling", "ratio", "protocol", "seed", "accuracy", "low", "high"});
  add_side(numbers, rows, own);
  add_side(numbers, rows_of_side(counterpart, here, source.grid().dataset), other);
  return numbers;
}

}  // namespace piae::figures
