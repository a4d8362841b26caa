#include "diagnosis/classifier.hpp"

#include <algorithm>

namespace piae::diagnosis {

std::vector<Label> most_likely(std::span<const float> scores, std::size_t classes) {
  std::vector<Label> labels;
  labels.reserve(scores.size() / classes);
  for (; !scores.empty(); scores = scores.subspan(classes)) {
    const auto row = scores.first(classes);
    labels.push_back(static_cast<Label>(std::ranges::max_element(row) - row.begin()));
  }
  return labels;
}

}  // namespace piae::diagnosis
