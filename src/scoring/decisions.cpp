#include "scoring/decisions.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>

namespace piae::scoring {

namespace {

/// Returns the rates over groups of `windows` windows; nothing if a class has no group.
std::optional<DecisionRates> rates_over(std::size_t windows, std::span<const Label> labels,
                                        std::span<const float> scores, std::size_t classes,
                                        const Places& places) {
  std::vector<Label> truths;
  std::vector<Label> decisions;
  for (const std::vector<std::size_t>& group : consecutive_groups(labels, places, windows)) {
    truths.push_back(labels[group.front()]);
    decisions.push_back(decide(scores, classes, group));
  }
  if (truths.empty() ||
      std::set(truths.begin(), truths.end()) != std::set(labels.begin(), labels.end())) {
    return std::nullopt;
  }
  const Confusion confusion = confusion_matrix(truths, decisions, classes);
  return DecisionRates{.windows = windows,
                       .decisions = truths.size(),
                       .accuracy = accuracy(confusion),
                       .balanced = balanced_accuracy(confusion)};
}

}  // namespace

std::vector<std::vector<std::size_t>> consecutive_groups(std::span<const Label> labels,
                                                         const Places& places,
                                                         std::size_t windows) {
  if (places.record.size() != labels.size() || places.first_sample.size() != labels.size()) {
    throw std::logic_error("labels and places differ in number");
  }
  if (windows == 0) throw std::logic_error("a decision needs at least one window");
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), 0);
  const auto source_of = [&](std::size_t i) { return std::tuple(labels[i], places.record[i]); };
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::tuple_cat(source_of(i), std::tuple(places.first_sample[i]));
  });
  std::vector<std::vector<std::size_t>> groups;
  for (auto first = order.begin(); first != order.end();) {
    const auto end = std::find_if(first, order.end(),
                                  [&](std::size_t i) { return source_of(i) != source_of(*first); });
    const auto step = static_cast<std::ptrdiff_t>(windows);
    for (; end - first >= step; first += step) groups.emplace_back(first, first + step);
    first = end;
  }
  return groups;
}

Label decide(std::span<const float> scores, std::size_t classes,
             std::span<const std::size_t> group) {
  std::vector<double> sums(classes);
  for (const std::size_t window : group) {
    const auto own = scores.subspan(window * classes, classes);
    std::ranges::transform(sums, own, sums.begin(), std::plus<double>());
  }
  return static_cast<Label>(std::ranges::max_element(sums) - sums.begin());
}

std::vector<DecisionRates> decision_rates(std::span<const Label> labels,
                                          std::span<const float> scores, std::size_t classes,
                                          const Places& places) {
  std::vector<DecisionRates> all;
  for (const std::size_t windows : decided_windows) {
    const auto rates = rates_over(windows, labels, scores, classes, places);
    if (rates) all.push_back(*rates);
  }
  return all;
}

}  // namespace piae::scoring
