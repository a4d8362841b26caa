#include "scoring/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace piae::scoring {

std::vector<ScoreBin> reliability(std::span<const Judgement> judgements, std::size_t bins) {
  const auto width = 1.0 / static_cast<double>(bins);
  std::vector<ScoreBin> all(bins);
  for (std::size_t i = 0; i < bins; ++i) {
    all[i].from = static_cast<double>(i) * width;
    all[i].to = static_cast<double>(i + 1) * width;
  }
  for (const Judgement& judgement : judgements) {
    const double place = std::ceil(judgement.score * static_cast<double>(bins)) - 1;
    ScoreBin& bin =
        all[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins - 1)))];
    ++bin.count;
    bin.mean_score += judgement.score;
    bin.accuracy += judgement.right ? 1 : 0;
  }
  for (ScoreBin& bin : all) {
    if (bin.count == 0) continue;
    bin.mean_score /= static_cast<double>(bin.count);
    bin.accuracy /= static_cast<double>(bin.count);
  }
  return all;
}

double expected_calibration_error(std::span<const ScoreBin> bins) {
  double weighted = 0;
  double count = 0;
  for (const ScoreBin& bin : bins) {
    weighted += static_cast<double>(bin.count) * std::abs(bin.accuracy - bin.mean_score);
    count += static_cast<double>(bin.count);
  }
  if (count == 0) throw std::logic_error("calibration needs at least one prediction");
  return weighted / count;
}

}  // namespace piae::scoring
