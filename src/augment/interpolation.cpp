#include "augment/interpolation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace piae::augment {

namespace {

double squared_distance(Window a, Window b) {
  if (a.size() != b.size()) throw std::logic_error("distance between windows of different lengths");
  double sum = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    const double difference = static_cast<double>(a[t]) - static_cast<double>(b[t]);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> nearest_to(std::size_t i, const std::vector<Window>& windows,
                                    std::size_t k) {
  if (k >= windows.size()) throw std::logic_error("more neighbours requested than there are");
  std::vector<std::pair<double, std::size_t>> others;
  for (std::size_t j = 0; j < windows.size(); ++j) {
    if (j != i) others.emplace_back(squared_distance(windows[i], windows[j]), j);
  }
  std::ranges::sort(others);
  std::vector<std::size_t> nearest;
  for (std::size_t rank = 0; rank < k; ++rank) nearest.push_back(others[rank].second);
  return nearest;
}

std::vector<std::vector<std::size_t>> nearest_neighbours(const std::vector<Window>& windows,
                                                         std::size_t k) {
  if (k >= windows.size()) throw std::logic_error("more neighbours requested than there are");
  std::vector<std::vector<std::size_t>> neighbours;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    neighbours.push_back(nearest_to(i, windows, k));
  }
  return neighbours;
}

std::vector<float> interpolate(Window base, Window neighbour, double gap) {
  std::vector<float> between;
  for (std::size_t t = 0; t < base.size(); ++t) {
    const auto from = static_cast<double>(base[t]);
    between.push_back(static_cast<float>(from + gap * (static_cast<double>(neighbour[t]) - from)));
  }
  return between;
}

}  // namespace piae::augment
