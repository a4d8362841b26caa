#include "scoring/refusal.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace piae::scoring {

namespace {

/// Number of windows with a prediction at some threshold, and of correct ones among them.
struct Answered {
  std::size_t count = 0;
  std::size_t right = 0;
};

/// Returns the counts for each score that any window has, from the largest on.
std::vector<Answered> by_threshold(std::span<const Judgement> judgements) {
  if (judgements.empty()) throw std::logic_error("refusals need at least one prediction");
  std::vector<Judgement> sorted(judgements.begin(), judgements.end());
  std::ranges::sort(sorted, std::greater(), &Judgement::score);
  std::vector<Answered> thresholds;
  Answered so_far;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    ++so_far.count;
    so_far.right += sorted[i].right ? 1 : 0;
    const bool is_last_of_score = i + 1 == sorted.size() || sorted[i + 1].score < sorted[i].score;
    if (is_last_of_score) thresholds.push_back(so_far);
  }
  return thresholds;
}

}  // namespace

double answerable_share(std::span<const Judgement> judgements, std::size_t precision_percent) {
  std::size_t most = 0;
  for (const Answered& answered : by_threshold(judgements)) {
    if (100 * answered.right >= precision_percent * answered.count) most = answered.count;
  }
  return static_cast<double>(most) / static_cast<double>(judgements.size());
}

std::vector<double> precision_by_share(std::span<const Judgement> judgements, std::size_t steps) {
  if (steps == 0) throw std::logic_error("precisions by share need at least one step");
  const std::vector<Answered> thresholds = by_threshold(judgements);
  std::vector<double> precisions;
  precisions.reserve(steps);
  Answered before;
  auto next = thresholds.begin();
  for (std::size_t step = 1; step <= steps; ++step) {
    const double wanted = static_cast<double>(step) * static_cast<double>(judgements.size()) /
                          static_cast<double>(steps);
    while (static_cast<double>(next->count) < wanted) before = *next++;
    const double part = (wanted - static_cast<double>(before.count)) /
                        static_cast<double>(next->count - before.count);
    const double right =
        static_cast<double>(before.right) + part * static_cast<double>(next->right - before.right);
    precisions.push_back(right / wanted);
  }
  return precisions;
}

}  // namespace piae::scoring
