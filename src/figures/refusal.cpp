#include "figures/refusal.hpp"

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "scoring/confidence.hpp"
#include "scoring/refusal.hpp"

namespace piae::figures {

namespace {

/// Returns the mean precision over the seeds of a row for each of `steps` equal parts of the
/// windows, in percent.
std::vector<double> mean_precisions(const Source& source, const report::AccuracyRow& row,
                                    std::size_t steps) {
  std::vector<double> mean(steps);
  const double weight = 100.0 / static_cast<double>(row.seeds.size());
  for (const scoring::DiagnosisRecord& record :
       source.diagnoses({row.method, row.ratio, row.classifier}, row.seeds)) {
    const auto own = scoring::precision_by_share(scoring::judgements_of(record), steps);
    std::ranges::transform(own, mean, mean.begin(),
                           [&](double share, double sum) { return sum + weight * share; });
  }
  return mean;
}

}  // namespace

Numbers refusals(Source& source, const report::ClassifierRows& shown) {
  constexpr std::size_t steps = 100;
  Numbers numbers({"method", "ceiling", "ratio", "answered", "precision"});
  for (const auto& [label, row] : report::rows_with_most_windows(shown)) {
    const bool is_reference = row.classifier != shown.classifier;
    const std::string name = is_reference ? row.classifier : row.method;
    const std::string ceiling = augment::is_ceiling(row.method) ? "1" : "0";
    const std::vector<double> precisions = mean_precisions(source, row, steps);
    for (std::size_t step = 0; step < steps; ++step) {
      numbers.row({name, ceiling, row.ratio, std::to_string(step + 1), digits(precisions[step])});
    }
  }
  return numbers;
}

}  // namespace piae::figures
