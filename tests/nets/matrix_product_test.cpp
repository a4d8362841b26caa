#include "nets/matrix_product.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"
#include "base/vector.hpp"

namespace piae::nets {
namespace {

std::vector<double> drawn_numbers(std::int64_t n, const char* name) {
  Stream stream(name);
  std::vector<double> numbers(static_cast<std::size_t>(n));
  for (double& x : numbers) x = stream.normal(0, 1);
  return numbers;
}

/// Compares with the definition, number by number. C starts with other numbers; the gaps between
/// its rows must not change.
void expect_equals_definition(MatrixProduct<double> p) {
  for (const std::int64_t gap : {0, 5}) {
    for (const bool add : {false, true}) {
      p.c_row = p.columns + gap;
      p.add = add;
      std::vector<double> c(static_cast<std::size_t>(p.rows * p.c_row), 7);
      p.c = c.data();
      multiply(p);
      for (std::int64_t row = 0; row < p.rows; ++row) {
        for (std::int64_t column = 0; column < p.c_row; ++column) {
          double sum = add || column >= p.columns ? 7 : 0;
          for (std::int64_t block = 0; block < p.blocks && column < p.columns; ++block) {
            for (std::int64_t k = 0; k < p.depth; ++k) {
              sum += p.a[block * p.a_block + row * p.a_row + k * p.a_column] *
                     p.b[block * p.b_block + k * p.b_row + column];
            }
          }
          ASSERT_NEAR(c[static_cast<std::size_t>(row * p.c_row + column)], sum, 1e-12)
              << row << ", " << column << " of " << p.rows << " x " << p.columns;
        }
      }
    }
  }
}

class MatrixProductShapes : public testing::TestWithParam<std::int64_t> {};

// From less than a tile to several with every remainder, in rows and, by whole vectors, in columns.
INSTANTIATE_TEST_SUITE_P(Rows, MatrixProductShapes, testing::Range<std::int64_t>(1, 20));

TEST_P(MatrixProductShapes, MatchTheDefinition) {
  const std::vector<double> a = drawn_numbers(1000, "a");
  const std::vector<double> b = drawn_numbers(3000, "b");
  for (std::int64_t columns = row_granule; columns <= 9 * row_granule; columns += row_granule) {
    for (const std::int64_t b_row : {columns, columns + row_granule}) {
      expect_equals_definition({.a = a.data(),
                                .a_row = 5,
                                .a_column = 1,
                                .b = b.data(),
                                .b_row = b_row,
                                .c = nullptr,
                                .c_row = 0,
                                .rows = GetParam(),
                                .columns = columns,
                                .depth = 5});
    }
  }
}

TEST(MatrixProduct, MatchesTheDefinitionForTransposedAndOverlappingMatricesInBlocks) {
  const std::vector<double> a = drawn_numbers(1000, "a");
  const std::vector<double> b = drawn_numbers(2000, "b");
  MatrixProduct<double> product{.a = a.data(),
                                .a_row = 1,
                                .a_column = 16,
                                .b = b.data(),
                                .b_row = 32,
                                .c = nullptr,
                                .c_row = 0,
                                .rows = 16,
                                .columns = 32,
                                .depth = 9};
  expect_equals_definition(product);  // transposed
  product.a_row = 4;
  product.a_column = 1;
  expect_equals_definition(product);  // overlapping
  product.a_block = 90;
  product.b_block = 96;
  for (const std::int64_t blocks : {3, 0}) {  // no blocks give 0
    product.blocks = blocks;
    expect_equals_definition(product);
  }
}

TEST(MatrixProduct, RowDoesNotDependOnOtherRows) {
  const std::vector<double> numbers = drawn_numbers(2000, "a");
  const std::vector<float> a(numbers.begin(), numbers.end());
  const std::vector<float> b(numbers.rbegin(), numbers.rend());
  std::vector<float> together(std::size_t{19} * 48);
  std::vector<float> alone(48);
  const auto product = [&](std::size_t first, std::int64_t rows, std::vector<float>& c) {
    multiply<float>({.a = a.data() + 30 * first,
                     .a_row = 30,
                     .a_column = 1,
                     .b = b.data(),
                     .b_row = 48,
                     .c = c.data(),
                     .c_row = 48,
                     .rows = rows,
                     .columns = 48,
                     .depth = 30});
  };
  product(0, 19, together);
  for (std::size_t row = 0; row < 19; ++row) {
    product(row, 1, alone);
    EXPECT_EQ(alone, std::vector(together.begin() + static_cast<std::ptrdiff_t>(48 * row),
                                 together.begin() + static_cast<std::ptrdiff_t>(48 * (row + 1))));
  }
}

}  // namespace
}  // namespace piae::nets
