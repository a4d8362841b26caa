#include "zero/ball.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "impacts/strengths.hpp"
#include "zero/draws.hpp"

namespace piae::zero {

namespace {

constexpr double half_a_period = 0.5;
/// Unit: turns of the cage.
constexpr double least_memory = 0.5;
constexpr double longest_memory = 20;

/// Returns the number that a standard normal variable exceeds with this probability (below 1).
double exceeded_by(double share) {
  return boost::math::quantile(boost::math::complement(boost::math::normal(), share));
}

/// Returns `count` standard normal numbers with this correlation from one to the next.
std::vector<double> wandering(std::size_t count, double correlation, Stream& random) {
  std::vector<double> numbers(count);
  const double fresh = std::sqrt(1 - correlation * correlation);
  double now = random.normal(0, 1);
  for (double& number : numbers) {
    number = now;
    now = correlation * now + fresh * random.normal(0, 1);
  }
  return numbers;
}

}  // namespace

void alternate_races(const Prior& prior, Stream& random, std::vector<impacts::Impact>& impacts) {
  const double weaker = evenly(random, prior.other_race, 1);
  impacts::weaken_every_second(weaker, random.below(2), impacts);
}

void turn_between_passes(double period_s, double cage_hz, const Prior& prior, Stream& random,
                         std::vector<impacts::Impact>& impacts) {
  const double probability = random.uniform(0, 1) * prior.new_phase;
  const double began = random.uniform(0, 1);
  double turn = 0;
  double offset_s = 0;
  for (impacts::Impact& impact : impacts) {
    const double now = std::floor(impact.time_s * cage_hz + began);
    if (now > turn && bernoulli(random, probability)) {
      offset_s = period_s * evenly(random, -half_a_period, half_a_period);
    }
    turn = now;
    impact.time_s += offset_s;
  }
}

void scatter_in_time(double frame_s, const Prior& prior, Stream& random,
                     std::vector<impacts::Impact>& impacts) {
  const double share = random.uniform(0, 1) * prior.random_impacts;
  for (impacts::Impact& impact : impacts) {
    if (bernoulli(random, share)) impact.time_s = random.uniform(0, frame_s);
  }
}

void leave_track(double period_s, double cage_hz, double frame_s, const Prior& prior,
                 Stream& random, std::vector<impacts::Impact>& impacts) {
  const double memory_s = log_evenly(random, least_memory, longest_memory) / cage_hz;
  const double share = evenly(random, prior.least_on_track, 1);
  if (share <= 0 || share >= 1) return;
  const auto steps = static_cast<std::size_t>(std::ceil(frame_s / period_s)) + 1;
  const std::vector<double> axis = wandering(steps, std::exp(-period_s / memory_s), random);
  const double threshold = exceeded_by(share);
  for (impacts::Impact& impact : impacts) {
    const double step = std::clamp(impact.time_s / period_s, 0.0, static_cast<double>(steps - 1));
    if (axis[static_cast<std::size_t>(step)] <= threshold) impact.strength *= off_track;
  }
}

}  // namespace piae::zero
