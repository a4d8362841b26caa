#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raw/variable_path.hpp"

namespace piae::raw {

using Shape = std::vector<std::size_t>;

/// Names a variable in an error.
struct Where {
  const std::filesystem::path& file;
  const char* noun;  ///< "variable", "dataset"
  std::string name;
};

/// An array of numbers. `numbers` reads them when called.
struct Array {
  Shape shape;
  bool is_column_major;  ///< first index varies fastest, as in MATLAB; otherwise the last one
  std::function<std::vector<double>()> numbers;
};

/// Throws Error(bad_input) with "FILE: variable K.Y <what>".
[[noreturn]] void refuse(const Where& where, const std::string& what);

/// Returns the product of the extents, or the largest number on overflow.
std::size_t count_of(const Shape& shape);

/// Returns the number of values in an array of these extents. Throws Error(bad_input) if the file
/// cannot hold them (limits.hpp).
std::size_t possible_count(const Where& where, const Shape& shape);

/// Returns a vector, or a row or column of a matrix. Throws Error(bad_input) if the array is
/// neither; the error names a row or column of a matrix.
std::vector<double> vector_of(const Where& where, const Array& array,
                              const std::optional<MatrixLine>& line);

}  // namespace piae::raw
