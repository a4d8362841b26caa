#pragma once

#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {

/// Returns standard normal numbers in double precision.
inline torch::Tensor random_tensor(Stream& stream, std::int64_t rows, std::int64_t columns) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < rows * columns; ++i) values.push_back(stream.normal(0, 1));
  return torch::tensor(values, torch::kFloat64).view({rows, columns});
}

}  // namespace piae::libtorch
