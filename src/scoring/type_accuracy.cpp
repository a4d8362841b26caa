#include "scoring/type_accuracy.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace piae::scoring {

double type_accuracy(const Confusion& confusion, std::span<const signal::ClassInfo> classes) {
  if (classes.size() != confusion.classes) {
    throw std::logic_error("a class of the confusion matrix has no defect");
  }
  std::vector<std::size_t> fault_types;
  std::size_t count = 0;
  for (const signal::ClassInfo& each : classes) {
    fault_types.push_back(static_cast<std::size_t>(each.defect));
    count = std::max(count, fault_types.back() + 1);
  }
  Confusion of_types{count, std::vector<std::int64_t>(count * count)};
  for (std::size_t truth = 0; truth < fault_types.size(); ++truth) {
    for (std::size_t named = 0; named < fault_types.size(); ++named) {
      of_types.counts[fault_types[truth] * count + fault_types[named]] +=
          confusion.at(truth, named);
    }
  }
  return accuracy(of_types);
}

}  // namespace piae::scoring
