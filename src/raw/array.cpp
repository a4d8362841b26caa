#include "raw/array.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "raw/file.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

std::vector<double> line_of(const std::vector<double>& numbers, const MatrixLine& line,
                            const Shape& matrix, bool is_column_major) {
  const std::size_t rows = matrix[0];
  const std::size_t columns = matrix[1];
  std::vector<double> values(line.is_row ? columns : rows);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t row = line.is_row ? line.number - 1 : i;
    const std::size_t column = line.is_row ? i : line.number - 1;
    values[i] = numbers[is_column_major ? row + column * rows : row * columns + column];
  }
  return values;
}

/// Refuses an array that is not a vector; the error names a row or column of a matrix.
void require_vector(const Where& where, const Shape& shape) {
  Shape extents = shape;
  std::erase(extents, 1);
  if (extents.size() < 2) return;
  if (extents.size() > 2 || shape.size() != 2) {
    refuse(where,
           fmt::format("is not a vector, but an array of {}; save the samples as a vector or "
                       "matrix",
                       fmt::join(shape, " x ")));
  }
  const bool by_rows = shape[0] <= shape[1];
  refuse(where, fmt::format("is not a vector, but a matrix of {} x {}; name a {} of it: {}{}",
                            shape[0], shape[1], by_rows ? "row" : "column", where.name,
                            by_rows ? "(1,:)" : "(:,1)"));
}

}  // namespace

std::size_t count_of(const Shape& shape) {
  if (std::ranges::count(shape, 0) > 0) return 0;
  std::size_t count = 1;
  for (const std::size_t extent : shape) {
    if (count > std::numeric_limits<std::size_t>::max() / extent) {
      return std::numeric_limits<std::size_t>::max();
    }
    count *= extent;
  }
  return count;
}

void refuse(const Where& where, const std::string& what) {
  const std::string name = where.name.empty() ? "" : " " + where.name;
  refuse_file(where.file, fmt::format("{}{} {}", where.noun, name, what));
}

std::size_t possible_count(const Where& where, const Shape& shape) {
  const std::size_t count = count_of(shape);
  const std::uint64_t most = limits_of(where.file).most_samples;
  if (count > most) {
    refuse(where,
           fmt::format(
               "declares {} values, but a file of this size holds at most {}; the file is damaged",
               count, most));
  }
  return count;
}

std::vector<double> vector_of(const Where& where, const Array& array,
                              const std::optional<MatrixLine>& line) {
  const Shape& shape = array.shape;
  if (possible_count(where, shape) == 0) return {};
  if (!line) {
    require_vector(where, shape);
    return array.numbers();
  }
  if (shape.size() != 2) {
    refuse(where, fmt::format("is not a matrix, its size is {}; leave out the row or column",
                              fmt::join(shape, " x ")));
  }
  const std::size_t there = line->is_row ? shape[0] : shape[1];
  if (line->number > there) {
    refuse(where, fmt::format("has {} {}; number {} does not exist", there,
                              line->is_row ? "rows" : "columns", line->number));
  }
  return line_of(array.numbers(), *line, shape, array.is_column_major);
}

}  // namespace piae::raw
