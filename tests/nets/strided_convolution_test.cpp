#include "nets/strided_convolution.hpp"

#include <gtest/gtest.h>

#include "base/vector.hpp"
#include "nets/convolution_example.hpp"
#include "nets/padded_batch.hpp"

namespace piae::nets {
namespace {

// 3 and 8 fine channels: rows of the transposed product that are filled up, and whole ones.
class StridedConvolutions : public testing::TestWithParam<StridedConvolution> {
 protected:
  static constexpr std::int64_t rows = 2;
  static constexpr std::int64_t padding = 3;  // more than is needed

  static double dot(const PaddedBatch<double>& a, const PaddedBatch<double>& b) {
    auto x = a;
    auto y = b;
    return (x.all(0, rows) * y.all(0, rows)).sum();
  }
  static PaddedBatch<double> signals(const std::string& name, std::int64_t length,
                                     std::int64_t channels) {
    PaddedBatch<double> batch(rows, length, channels, padding);
    put(drawn(name, rows, length * channels), batch.rows());
    return batch;
  }
  [[nodiscard]] std::int64_t weight_columns() const {
    return shape_.fine_channels * shape_.kernel();
  }
  Rows<double> weight() { return {weight_.data(), weight_columns()}; }

  const StridedConvolution shape_ = GetParam();
  PaddedBatch<double> fine_ = signals("fine", shape_.fine_length(), shape_.fine_channels);
  PaddedBatch<double> coarse_ = signals("coarse", shape_.coarse_length, shape_.coarse_channels);
  RowArray<double> weight_ = drawn("weight", shape_.coarse_channels, weight_columns());
};

TEST_P(StridedConvolutions, EqualTheDefinition) {
  PaddedBatch<double> to(rows, shape_.coarse_length, shape_.coarse_channels, padding);
  convolve<double>(shape_, rows, fine_.rows(), weight(), to.rows());
  for (std::int64_t r = 0; r < rows; ++r) {
    for (std::int64_t t = 0; t < shape_.coarse_length; ++t) {
      for (std::int64_t o = 0; o < shape_.coarse_channels; ++o) {
        double sum = 0;
        for (std::int64_t j = 0; j < shape_.kernel(); ++j) {
          const std::int64_t time = shape_.stride * t - shape_.padding() + j;
          if (time < 0 || time >= shape_.fine_length()) continue;
          for (std::int64_t c = 0; c < shape_.fine_channels; ++c) {
            sum += fine_.rows().row(r)[time * shape_.fine_channels + c] *
                   weight_(o, c * shape_.kernel() + j);
          }
        }
        EXPECT_NEAR(to.rows().row(r)[t * shape_.coarse_channels + o], sum, 1e-12);
      }
    }
  }
}

// The transposed map A' of a linear map A: y . A x = A' y . x for any x and y.
TEST_P(StridedConvolutions, AreTransposed) {
  PaddedBatch<double> to_coarse(rows, shape_.coarse_length, shape_.coarse_channels, padding);
  convolve<double>(shape_, rows, fine_.rows(), weight(), to_coarse.rows());
  PaddedBatch<double> to_fine(rows, shape_.fine_length(), shape_.fine_channels, padding);
  to_fine.all(0, rows) = 7;  // what stood there before
  PaddedBatch<double> inside(rows, shape_.fine_length(), shape_.fine_channels, padding);
  put<double>(RowArray<double>::Ones(rows, shape_.fine_length() * shape_.fine_channels),
              inside.rows());
  to_fine.all(0, rows) *= inside.all(0, rows);
  convolve_transposed<double>(shape_, rows, coarse_.rows(), weight(), to_fine.rows());
  EXPECT_NEAR(dot(coarse_, to_coarse), dot(to_fine, fine_), 1e-10);
  // Nothing is left beyond the ends.
  EXPECT_EQ(((inside.all(0, rows) == 0) && (to_fine.all(0, rows) != 0)).count(), 0);
}

// The convolution is linear in its weight W, too: y . A(W) x = W . gradient.
TEST_P(StridedConvolutions, HaveTheirGradientByTheWeight) {
  PaddedBatch<double> to(rows, shape_.coarse_length, shape_.coarse_channels, padding);
  RowArray<double> gradient(weight_.rows(), weight_.cols());
  weight_gradient<double>(shape_, rows, fine_.rows(), coarse_.rows(),
                          {gradient.data(), weight_columns()});
  for (const char* name : {"one weight", "another"}) {
    weight_ = drawn(name, weight_.rows(), weight_.cols());
    convolve<double>(shape_, rows, fine_.rows(), weight(), to.rows());
    EXPECT_NEAR(dot(coarse_, to), (weight_ * gradient).sum(), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Nets, StridedConvolutions,
    testing::Values(StridedConvolution{1, 16, 4, 9}, StridedConvolution{3, 16, 2, 5},
                    StridedConvolution{8, 32, 4, 3}, StridedConvolution{16, 32, 6, 1}),
    [](const auto& info) {
      return std::to_string(info.param.fine_channels) + "By" + std::to_string(info.param.stride);
    });

}  // namespace
}  // namespace piae::nets
