#include "nets/row_product.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"

namespace piae::nets {
namespace {

/// Small whole numbers: their products and sums are exact in any order.
template <class T>
std::vector<T> whole_numbers(const std::string& name, std::int64_t size) {
  Stream stream(name);
  std::vector<T> numbers;
  for (std::int64_t i = 0; i < size; ++i) {
    numbers.push_back(static_cast<T>(static_cast<int>(stream.below(9)) - 4));
  }
  return numbers;
}

template <class T>
class RowProducts : public testing::Test {};
using FloatAndDouble = testing::Types<float, double>;
TYPED_TEST_SUITE(RowProducts, FloatAndDouble);

TYPED_TEST(RowProducts, EqualTheSumOfProducts) {
  using T = TypeParam;
  constexpr std::int64_t gap = 5;  // between rows of C, whose numbers must not change
  for (const std::int64_t rows : {1, 2, 5, 6, 7, 11, 12, 13}) {
    for (const std::int64_t columns : {16, 32, 48, 64, 96, 112}) {
      for (const std::int64_t depth : {0, 1, 33}) {
        for (const bool transposed : {false, true}) {
          const auto a = whole_numbers<T>("a", rows * depth);
          const auto b = whole_numbers<T>("b", (columns + 16) * depth);
          const auto start = whole_numbers<T>("c", rows * (columns + gap));
          std::vector<T> set = start;
          std::vector<T> added = start;
          RowProduct<T> product{.a = a.data(),
                                .a_row = transposed ? 1 : depth,
                                .a_column = transposed ? rows : 1,
                                .b = b.data(),
                                .b_row = columns + 16,
                                .c = set.data(),
                                .c_row = columns + gap,
                                .rows = rows,
                                .columns = columns,
                                .depth = depth};
          set_product(product);
          product.c = added.data();
          add_product(product);
          for (std::int64_t i = 0; i < rows; ++i) {
            for (std::int64_t j = 0; j < columns + gap; ++j) {
              const auto at = static_cast<std::size_t>(i * (columns + gap) + j);
              T sum = 0;
              for (std::int64_t k = 0; k < depth && j < columns; ++k) {
                sum += a[static_cast<std::size_t>(i * product.a_row + k * product.a_column)] *
                       b[static_cast<std::size_t>(k * product.b_row + j)];
              }
              ASSERT_EQ(set[at], j < columns ? sum : start[at]) << rows << " " << columns;
              ASSERT_EQ(added[at], start[at] + sum) << rows << " " << columns;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace piae::nets
