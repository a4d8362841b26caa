#include "figures/most_windows.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"

namespace piae::figures {

namespace {

/// Returns the last cell of each method; the ratios of a method stand together, in the order of
/// Table 5.
std::vector<run::Combination> last_cells(const run::Grid& grid) {
  std::vector<run::Combination> cells;
  for (const run::Combination& cell : grid.combinations) {
    if (cells.empty() || cells.back().method != cell.method) cells.emplace_back();
    cells.back() = cell;
  }
  return cells;
}

bool belong_together(const scoring::DiagnosisRecord& one, const scoring::DiagnosisRecord& other) {
  return one.protocol == other.protocol &&
         std::ranges::equal(one.info.classes, other.info.classes, {}, &signal::ClassInfo::name,
                            &signal::ClassInfo::name);
}

}  // namespace

scoring::Confusion MethodDiagnoses::confusion() const {
  scoring::Confusion sum = seeds.front().confusion();
  for (std::size_t i = 1; i < seeds.size(); ++i) {
    const scoring::Confusion own = seeds[i].confusion();
    std::ranges::transform(sum.counts, own.counts, sum.counts.begin(), std::plus());
  }
  return sum;
}

std::vector<std::string> MethodDiagnoses::fields() const {
  return {cell.method, augment::is_ceiling(cell.method) ? "1" : "0", cell.ratio};
}

std::vector<MethodDiagnoses> diagnoses_with_most_windows(const Source& source) {
  if (source.grid().combinations.empty()) {
    throw LeftOut(std::string("the run has no diagnosis by ") + scoring::paper_classifier);
  }
  std::vector<MethodDiagnoses> all;
  for (const run::Combination& cell : last_cells(source.grid())) {
    const MethodDiagnoses& own = all.emplace_back(
        MethodDiagnoses{.cell = cell, .seeds = source.diagnoses(cell, source.seeds_of(cell))});
    for (const scoring::DiagnosisRecord& record : own.seeds) {
      if (belong_together(record, all.front().seeds.front())) continue;
      throw Error(Exit::bad_input,
                  source.layout().diagnosis(cell.method, cell.ratio, record.seed).string() +
                      ": its classes or its split differ from those of the others");
    }
  }
  return all;
}

}  // namespace piae::figures
