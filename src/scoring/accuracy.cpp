#include "scoring/accuracy.hpp"

#include <numeric>
#include <stdexcept>

namespace piae::scoring {

namespace {

std::size_t checked(Label label, std::size_t classes) {
  if (label < 0 || index_of(label) >= classes) {
    throw std::logic_error("class " + std::to_string(label) + " of " + std::to_string(classes));
  }
  return index_of(label);
}

}  // namespace

void add(Confusion& sum, const Confusion& confusion) {
  if (sum.counts.empty()) {
    sum = confusion;
    return;
  }
  if (sum.classes != confusion.classes)
    throw std::logic_error("confusion matrices of different classes");
  for (std::size_t i = 0; i < sum.counts.size(); ++i) sum.counts[i] += confusion.counts[i];
}

Confusion confusion_matrix(std::span<const Label> labels, std::span<const Label> predictions,
                           std::size_t classes) {
  if (labels.size() != predictions.size()) {
    throw std::logic_error("labels and predictions differ in number");
  }
  Confusion confusion{classes, std::vector<std::int64_t>(classes * classes, 0)};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::size_t truth = checked(labels[i], classes);
    ++confusion.counts[truth * classes + checked(predictions[i], classes)];
  }
  return confusion;
}

double accuracy(const Confusion& confusion) {
  const std::int64_t all =
      std::accumulate(confusion.counts.begin(), confusion.counts.end(), std::int64_t{0});
  if (all == 0) throw std::logic_error("accuracy needs at least one window");
  std::int64_t right = 0;
  for (std::size_t i = 0; i < confusion.classes; ++i) right += confusion.at(i, i);
  return static_cast<double>(right) / static_cast<double>(all);
}

double balanced_accuracy(const Confusion& confusion) {
  double sum = 0;
  std::size_t tested = 0;
  for (std::size_t truth = 0; truth < confusion.classes; ++truth) {
    const auto row =
        std::span(confusion.counts).subspan(truth * confusion.classes, confusion.classes);
    const std::int64_t all = std::accumulate(row.begin(), row.end(), std::int64_t{0});
    if (all == 0) continue;
    ++tested;
    sum += static_cast<double>(row[truth]) / static_cast<double>(all);
  }
  if (tested == 0) throw std::logic_error("accuracy needs at least one window");
  return sum / static_cast<double>(tested);
}

}  // namespace piae::scoring
