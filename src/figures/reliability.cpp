#include "figures/reliability.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "augment/catalogue.hpp"
#include "report/accuracies.hpp"
#include "scoring/confidence.hpp"

namespace piae::figures {

namespace {

/// Returns the judgements of the windows of all seeds.
std::vector<scoring::Judgement> pooled_judgements(const Source& source,
                                                  const report::AccuracyRow& row) {
  std::vector<scoring::Judgement> all;
  for (const scoring::DiagnosisRecord& record :
       source.diagnoses({row.method, row.ratio, row.classifier}, row.seeds)) {
    std::ranges::copy(scoring::judgements_of(record), std::back_inserter(all));
  }
  return all;
}

void add_bin(Numbers& numbers, const report::AccuracyRow& of, const std::string& kind,
             const scoring::ScoreBin& bin, std::size_t windows, double gap) {
  const auto percent = [&](double share) { return digits(100 * share); };
  const auto if_any = [&](double share) { return bin.count > 0 ? percent(share) : ""; };
  numbers.row({of.method, augment::is_ceiling(of.method) ? "1" : "0", of.ratio, kind,
               percent(bin.from), percent(bin.to), std::to_string(bin.count),
               percent(static_cast<double>(bin.count) / static_cast<double>(windows)),
               if_any(bin.mean_score), if_any(bin.accuracy), if_any(gap)});
}

void add_bins(Numbers& numbers, const report::AccuracyRow& of,
              const std::vector<scoring::Judgement>& judgements) {
  const std::vector<scoring::ScoreBin> own =
      scoring::reliability(judgements, scoring::reliability_bins);
  for (const scoring::ScoreBin& bin : own) {
    add_bin(numbers, of, "bin", bin, judgements.size(), std::abs(bin.accuracy - bin.mean_score));
  }
  add_bin(numbers, of, "all", scoring::reliability(judgements, 1).front(), judgements.size(),
          scoring::expected_calibration_error(own));
}

}  // namespace

Numbers reliabilities(Source& source, const report::ClassifierRows& shown) {
  Numbers numbers({"method", "ceiling", "ratio", "kind", "score_from", "score_to", "windows",
                   "share", "mean_score", "accuracy", "gap"});
  bool ranks_answers = false;
  for (const auto& [name, row] : report::rows_with_most_windows(shown)) {
    const bool is_reference = row.classifier != shown.classifier;
    if (is_reference) continue;
    const std::vector<scoring::Judgement> judgements = pooled_judgements(source, row);
    ranks_answers |= scoring::ranks_answers(judgements);
    add_bins(numbers, row, judgements);
  }
  if (!ranks_answers) throw LeftOut(shown.classifier + " does not report a confidence");
  return numbers;
}

}  // namespace piae::figures
