#include "nets/matrix_product.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"
#include "base/vector.hpp"

namespace piae::nets {
namespace {

std::vector<double> random_numbers(std::int64_t n, const char* name) {
  Stream stream(name);
  std::vector<double> numbers(static_cast<std::size_t>(n));
  for (double& x : numbers) x = stream.normal(0, 1);
  return numbers;
}

/// Against the definition, number by number; C begins as something else.
void expect_equals_definition(MatrixProduct<double> p) {
  std::vector<double> c(static_cast<std::size_t>(p.rows * p.columns), 7);
  p.c = c.data();
  multiply(p);
  for (std::int64_t row = 0; row < p.rows; ++row) {
    for (std::int64_t column = 0; column < p.columns; ++column) {
      double sum = 0;
      for (std::int64_t block = 0; block < p.blocks; ++block) {
        for (std::int64_t k = 0; k < p.depth; ++k) {
          sum += p.a[block * p.a_block + row * p.a_row + k * p.a_column] *
                 p.b[block * p.b_block + k * p.columns + column];
        }
      }
      ASSERT_NEAR(c[static_cast<std::size_t>(row * p.columns + column)], sum, 1e-12)
          << row << ", " << column << " of " << p.rows << " x " << p.columns;
    }
  }
}

class MatrixProductShapes : public testing::TestWithParam<std::int64_t> {};

// From less than a tile to several with every remainder, in rows and, by whole vectors, in columns.
INSTANTIATE_TEST_SUITE_P(Rows, MatrixProductShapes, testing::Range<std::int64_t>(1, 20));

TEST_P(MatrixProductShapes, EqualTheDefinition) {
  const std::vector<double> a = random_numbers(1000, "a");
  const std::vector<double> b = random_numbers(3000, "b");
  for (std::int64_t columns = row_granule; columns <= 9 * row_granule; columns += row_granule) {
    expect_equals_definition({a.data(), 5, 1, 0, b.data(), 0, nullptr, GetParam(), columns, 5});
  }
}

TEST(MatrixProduct, EqualsTheDefinitionForTransposedAndOverlappingMatricesInBlocks) {
  const std::vector<double> a = random_numbers(1000, "a");
  const std::vector<double> b = random_numbers(2000, "b");
  expect_equals_definition({a.data(), 1, 16, 0, b.data(), 0, nullptr, 16, 32, 9});  // transposed
  expect_equals_definition({a.data(), 4, 1, 0, b.data(), 0, nullptr, 11, 16, 12});  // overlap
  expect_equals_definition({a.data(), 6, 1, 90, b.data(), 96, nullptr, 13, 16, 6, 3});  // blocks
  expect_equals_definition({a.data(), 6, 1, 90, b.data(), 96, nullptr, 13, 16, 6, 0});  // none: 0
}

TEST(MatrixProduct, ARowDoesNotDependOnThoseBesideIt) {
  const std::vector<double> numbers = random_numbers(2000, "a");
  const std::vector<float> a(numbers.begin(), numbers.end());
  const std::vector<float> b(numbers.rbegin(), numbers.rend());
  std::vector<float> together(std::size_t{19} * 48);
  std::vector<float> alone(48);
  multiply<float>({a.data(), 30, 1, 0, b.data(), 0, together.data(), 19, 48, 30});
  for (std::size_t row = 0; row < 19; ++row) {
    multiply<float>({a.data() + 30 * row, 30, 1, 0, b.data(), 0, alone.data(), 1, 48, 30});
    EXPECT_EQ(alone, std::vector(together.begin() + static_cast<std::ptrdiff_t>(48 * row),
                                 together.begin() + static_cast<std::ptrdiff_t>(48 * (row + 1))));
  }
}

}  // namespace
}  // namespace piae::nets
