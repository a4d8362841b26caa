#pragma once

#include <cstdint>
#include <string>

#include "base/random.hpp"
#include "nets/row_array.hpp"

namespace piae {

/// Returns normally distributed numbers.
inline nets::RowArray<double> random_array(const std::string& name, std::int64_t rows,
                                           std::int64_t columns) {
  Stream stream(name);
  nets::RowArray<double> array(rows, columns);
  for (double& x : array.reshaped()) x = stream.normal(0, 1);
  return array;
}

}  // namespace piae
