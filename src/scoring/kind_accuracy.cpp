#include "scoring/kind_accuracy.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace piae::scoring {

double kind_accuracy(const Confusion& confusion, std::span<const signal::ClassInfo> classes) {
  if (classes.size() != confusion.classes) {
    throw std::logic_error("a class of the confusion matrix has no defect");
  }
  std::vector<std::size_t> kinds;
  std::size_t count = 0;
  for (const signal::ClassInfo& each : classes) {
    kinds.push_back(static_cast<std::size_t>(each.defect));
    count = std::max(count, kinds.back() + 1);
  }
  Confusion of_kinds{count, std::vector<std::int64_t>(count * count)};
  for (std::size_t truth = 0; truth < kinds.size(); ++truth) {
    for (std::size_t named = 0; named < kinds.size(); ++named) {
      of_kinds.counts[kinds[truth] * count + kinds[named]] += confusion.at(truth, named);
    }
  }
  return accuracy(of_kinds);
}

}  // namespace piae::scoring
