#include "figures/reliability.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "figures/most_windows.hpp"
#include "scoring/confidence.hpp"

namespace piae::figures {

namespace {

/// Of the windows of all seeds.
std::vector<scoring::Judgement> pooled_judgements(const MethodDiagnoses& method) {
  std::vector<scoring::Judgement> all;
  for (const scoring::DiagnosisRecord& record : method.seeds) {
    std::ranges::copy(scoring::judgements_of(record), std::back_inserter(all));
  }
  return all;
}

void add_bin(Numbers& numbers, const MethodDiagnoses& method, const std::string& kind,
             const scoring::ScoreBin& bin, std::size_t windows, double gap) {
  const auto percent = [&](double share) { return digits(100 * share); };
  const auto if_any = [&](double share) { return bin.count > 0 ? percent(share) : ""; };
  std::vector<std::string> row = method.fields();
  row.insert(row.end(), {kind, percent(bin.from), percent(bin.to), std::to_string(bin.count),
                         percent(static_cast<double>(bin.count) / static_cast<double>(windows)),
                         if_any(bin.mean_score), if_any(bin.accuracy), if_any(gap)});
  numbers.row(row);
}

}  // namespace

Numbers reliabilities(Source& source) {
  Numbers numbers({"method", "ceiling", "ratio", "kind", "score_from", "score_to", "windows",
                   "share", "mean_score", "accuracy", "gap"});
  for (const MethodDiagnoses& method : diagnoses_with_most_windows(source)) {
    const std::vector<scoring::Judgement> judgements = pooled_judgements(method);
    const std::vector<scoring::ScoreBin> own =
        scoring::reliability(judgements, scoring::reliability_bins);
    for (const scoring::ScoreBin& bin : own) {
      add_bin(numbers, method, "bin", bin, judgements.size(),
              std::abs(bin.accuracy - bin.mean_score));
    }
    add_bin(numbers, method, "all", scoring::reliability(judgements, 1).front(), judgements.size(),
            scoring::expected_calibration_error(own));
  }
  return numbers;
}

}  // namespace piae::figures
