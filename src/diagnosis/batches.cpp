#include "diagnosis/batches.hpp"

namespace piae::diagnosis {

std::vector<std::int64_t> batch_bounds(std::int64_t n, std::int64_t batch) {
  std::vector<std::int64_t> bounds;
  // A batch needs at least two windows.
  for (std::int64_t begin = 0; begin < n - 1; begin += batch) bounds.push_back(begin);
  bounds.push_back(n);
  return bounds;
}

}  // namespace piae::diagnosis
