#include "transfer/cutting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace piae::transfer {

namespace {

/// Fractions of a period.
constexpr double lead_part = 0.12;
constexpr double tail_part = 0.35;
constexpr double fade_part = 0.25;
/// Samples over which one tail fades into another.
constexpr std::size_t longest_blend = 12;

/// Returns the last part of a random response, with random sign.
Cut draw_tail(const std::vector<Cut>& responses, Stream& random) {
  const Cut& whole = responses[random.below(responses.size())];
  const auto length = std::max<std::size_t>(
      1, static_cast<std::size_t>(tail_part * static_cast<double>(whole.size())));
  Cut tail(whole.end() - static_cast<std::ptrdiff_t>(length), whole.end());
  if (random.below(2) == 1) std::ranges::transform(tail, tail.begin(), std::negate{});
  return tail;
}

/// Appends a tail. Response and tail are independent, so their powers blend.
void append_blended(Cut& response, const Cut& tail) {
  const std::size_t blend = std::min({longest_blend, tail.size() / 2, response.size()});
  const std::size_t begin = response.size() - blend;
  for (std::size_t i = 0; i < blend; ++i) {
    const double part = static_cast<double>(i + 1) / static_cast<double>(blend + 1);
    response[begin + i] = std::sqrt(1 - part) * response[begin + i] + std::sqrt(part) * tail[i];
  }
  response.insert(response.end(), tail.begin() + static_cast<std::ptrdiff_t>(blend), tail.end());
}

Cut continued(Cut response, std::size_t length, const std::vector<Cut>& responses, Stream& random) {
  while (response.size() < length) append_blended(response, draw_tail(responses, random));
  response.resize(length);
  return response;
}

/// Fades the part that overlaps the next response linearly to 0.
void fade_out(Cut& response, std::size_t overlap) {
  const auto longest = static_cast<std::size_t>(fade_part * static_cast<double>(response.size()));
  const std::size_t length = std::min(longest, overlap);
  for (std::size_t i = 0; i < length; ++i) {
    response[response.size() - 1 - i] *=
        static_cast<double>(i + 1) / static_cast<double>(length + 1);
  }
}

void add_at(std::ptrdiff_t place, const Cut& response, std::vector<double>& window) {
  const auto end = static_cast<std::ptrdiff_t>(window.size());
  for (std::size_t i = 0; i < response.size(); ++i) {
    const std::ptrdiff_t at = place + static_cast<std::ptrdiff_t>(i);
    if (at >= 0 && at < end) window[static_cast<std::size_t>(at)] += response[i];
  }
}

}  // namespace

std::vector<Cut> cut_responses(std::span<const double> window, const Comb& comb) {
  const auto lead = static_cast<std::size_t>(lead_part * comb.period);
  const auto length = static_cast<std::size_t>(comb.period);
  std::vector<Cut> responses;
  for (const std::size_t impact : comb.impact_positions(window.size())) {
    if (impact < lead || impact - lead + length > window.size()) continue;
    const auto part = window.subspan(impact - lead, length);
    responses.emplace_back(part.begin(), part.end());
  }
  return responses;
}

ImpactWindow with_impacts(const std::vector<Cut>& responses, const impacts::ImpactRate& rate,
                          std::size_t length, Stream& random) {
  ImpactWindow window{.samples = std::vector<double>(length, 0.0), .impact_positions = {}};
  const auto gap = static_cast<std::size_t>(std::ceil(rate.period));
  const std::size_t longest = std::ranges::max(responses, {}, &Cut::size).size();
  std::size_t next = random.below(responses.size());
  const double lead = lead_part * static_cast<double>(longest);
  const auto end = static_cast<double>(length);
  // Impacts before the window still ring in it.
  const double first =
      -static_cast<double>(std::max(longest, gap)) - random.uniform(0, rate.period);
  impacts::for_each_impact(random, rate, first, end, [&](double place) {
    Cut response = responses[next];
    next = (next + 1) % responses.size();
    if (response.size() < gap) {
      response = continued(std::move(response), gap, responses, random);
    } else {
      fade_out(response, response.size() - gap);
    }
    add_at(std::lround(place), response, window.samples);
    const double impact = place + lead;
    if (impact >= 0 && impact < end) window.impact_positions.push_back(impact);
  });
  return window;
}

}  // namespace piae::transfer
