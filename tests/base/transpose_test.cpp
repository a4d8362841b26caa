#include "base/transpose.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace piae {
namespace {

template <class T>
void expect_transposed(std::int64_t rows, std::int64_t columns) {
  std::vector<T> from(static_cast<std::size_t>(rows * columns));
  std::iota(from.begin(), from.end(), T{1});
  std::vector<T> to(from.size() + 1, T{-1});
  transpose(rows, columns, from.data(), to.data());
  for (std::int64_t i = 0; i < rows; ++i) {
    for (std::int64_t j = 0; j < columns; ++j) {
      ASSERT_EQ(to[static_cast<std::size_t>(j * rows + i)],
                from[static_cast<std::size_t>(i * columns + j)])
          << rows << " x " << columns << ": row " << i << ", column " << j;
    }
  }
  EXPECT_EQ(to.back(), T{-1}) << "writes behind the end";
}

TEST(Transpose, MovesEachNumberOfAnyShape) {
  for (const std::int64_t rows : {0, 1, 3, 8, 15, 16, 17, 48, 112}) {
    for (const std::int64_t columns : {0, 1, 7, 16, 31, 64}) {
      expect_transposed<float>(rows, columns);
      expect_transposed<double>(rows, columns);
    }
  }
}

}  // namespace
}  // namespace piae
