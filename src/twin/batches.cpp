#include "twin/batches.hpp"

#include <algorithm>
#include <map>

namespace piae::twin {

namespace {

using Indices = std::vector<std::size_t>;

void cut_into(std::vector<Indices>& batches, const Indices& order, std::size_t size) {
  for (std::size_t i = 0; i < order.size(); i += size) {
    const auto from = order.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t count = std::min(size, order.size() - i);
    batches.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace

std::vector<Indices> batches_of_an_epoch(const std::vector<Label>& labels, Batches kind,
                                         std::size_t size, Stream& shuffle) {
  const Indices order = shuffle.permutation(labels.size());
  std::vector<Indices> batches;
  if (kind == Batches::mixed) {
    cut_into(batches, order, size);
    return batches;
  }
  std::map<Label, Indices> by_class;
  for (const std::size_t i : order) by_class[labels[i]].push_back(i);
  for (const auto& [_, own] : by_class) cut_into(batches, own, size);
  std::vector<Indices> in_random_order;
  for (const std::size_t i : shuffle.permutation(batches.size())) {
    in_random_order.push_back(std::move(batches[i]));
  }
  return in_random_order;
}

}  // namespace piae::twin
