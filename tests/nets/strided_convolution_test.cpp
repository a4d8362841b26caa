#include "nets/strided_convolution.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

/// 3 and 8 fine channels, and one, as in a recording. So rows of the product that makes the fine
/// side are padded or whole.
struct StridedShape {
  std::int64_t fine_channels;
  std::int64_t coarse_channels;
  std::int64_t stride;
  std::int64_t coarse_length;

  [[nodiscard]] std::int64_t fine_length() const { return stride * coarse_length; }
  [[nodiscard]] std::vector<ParameterSpec> specs(ConvolutionKind kind) const {
    return {{"net/conv/weight", {coarse_channels, fine_channels, 2 * stride}, 0.5},
            {"net/conv/bias",
             {kind == ConvolutionKind::strided ? coarse_channels : fine_channels},
             0.5}};
  }
  [[nodiscard]] LayerExample::Make layer(ConvolutionKind kind) const {
    const std::int64_t length = kind == ConvolutionKind::strided ? fine_length() : coarse_length;
    return [=](GradientArray<double>& parameters) {
      return std::make_unique<StridedConvolution<double>>(parameters, "conv", kind, length);
    };
  }
  [[nodiscard]] LayerExample example(ConvolutionKind kind) const {
    return LayerExample(layer(kind), specs(kind));
  }
};

class StridedConvolutions : public testing::TestWithParam<StridedShape> {
 protected:
  static constexpr std::int64_t windows = 2;
  static double number(const LayerExample& example, const std::string& name, std::int64_t row,
                       std::int64_t column) {
    const auto& p = example.parameters->find("net/conv/" + name);
    return example.parameters->data(
        Parameters<double>::Kept::value)[p.begin + row * p.held_columns + column];
  }
  const StridedShape shape_ = GetParam();
};

TEST_P(StridedConvolutions, EqualTheDefinition) {
  const LayerExample example = shape_.example(ConvolutionKind::strided);
  const std::vector<double> fine =
      random_numbers("fine", windows * shape_.fine_length() * shape_.fine_channels);
  const std::vector<double> coarse = example.forward(fine, windows);
  auto made = coarse.begin();
  for (std::int64_t w = 0; w < windows; ++w) {
    for (std::int64_t t = 0; t < shape_.coarse_length; ++t) {
      for (std::int64_t o = 0; o < shape_.coarse_channels; ++o) {
        double sum = number(example, "bias", 0, o);
        for (std::int64_t j = 0; j < 2 * shape_.stride; ++j) {
          const std::int64_t time = shape_.stride * t - shape_.stride / 2 + j;
          if (time < 0 || time >= shape_.fine_length()) continue;
          for (std::int64_t c = 0; c < shape_.fine_channels; ++c) {
            sum += fine[static_cast<std::size_t>(
                       (w * shape_.fine_length() + time) * shape_.fine_channels + c)] *
                   number(example, "weight", o, c * 2 * shape_.stride + j);
          }
        }
        EXPECT_NEAR(*made++, sum, 1e-12);
      }
    }
  }
}

// The transposed map A' of a linear map A: y . A x = A' y . x for any x and y. The output for zeros
// gives the biases, which are subtracted.
TEST_P(StridedConvolutions, AreTransposed) {
  const auto without_bias = [](const LayerExample& example, const std::vector<double>& x) {
    std::vector<double> y = example.forward(x, windows);
    const std::vector<double> biases = example.forward(std::vector<double>(x.size()), windows);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] -= biases[i];
    return y;
  };
  const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  const std::vector<double> fine =
      random_numbers("fine", windows * shape_.fine_length() * shape_.fine_channels);
  const std::vector<double> coarse =
      random_numbers("coarse", windows * shape_.coarse_length * shape_.coarse_channels);
  const LayerExample strided = shape_.example(ConvolutionKind::strided);
  const LayerExample transposed = shape_.example(ConvolutionKind::transposed);
  EXPECT_NEAR(dot(coarse, without_bias(strided, fine)), dot(without_bias(transposed, coarse), fine),
              1e-10);
  EXPECT_EQ(transposed.forward(std::vector<double>(coarse.size()), windows)[0],
            number(transposed, "bias", 0, 0));
}

TEST_P(StridedConvolutions, HaveTheGradientsOfFiniteDifferences) {
  for (const ConvolutionKind kind : {ConvolutionKind::strided, ConvolutionKind::transposed}) {
    LayerExample example = shape_.example(kind);
    expect_gradients_of_differences(example, windows);
  }
}

TEST_P(StridedConvolutions, KeepNoStateBetweenBatches) {
  for (const ConvolutionKind kind : {ConvolutionKind::strided, ConvolutionKind::transposed}) {
    expect_that_batches_leave_nothing_behind(shape_.layer(kind), shape_.specs(kind));
  }
}

INSTANTIATE_TEST_SUITE_P(Nets, StridedConvolutions,
                         testing::Values(StridedShape{1, 16, 4, 9}, StridedShape{3, 16, 2, 5},
                                         StridedShape{8, 32, 4, 3}, StridedShape{16, 32, 6, 1}),
                         [](const auto& info) {
                           return std::to_string(info.param.fine_channels) + "By" +
                                  std::to_string(info.param.stride);
                         });

TEST(StridedConvolution, RefusesImpossibleShapes) {
  const auto layer_of = [](std::vector<std::int64_t> weight, std::int64_t length) {
    const std::int64_t outputs = weight[0];
    return LayerExample(
        [=](GradientArray<double>& parameters) {
          return std::make_unique<StridedConvolution<double>>(parameters, "conv",
                                                              ConvolutionKind::strided, length);
        },
        {{"net/conv/weight", std::move(weight)}, {"net/conv/bias", {outputs}}});
  };
  EXPECT_NO_THROW(layer_of({16, 1, 8}, 8));
  EXPECT_THROW(layer_of({16, 1, 8}, 10), std::logic_error);  // not a multiple of 4
  EXPECT_THROW(layer_of({16, 1, 6}, 9), std::logic_error);   // odd stride
  EXPECT_THROW(layer_of({16, 1, 9}, 8), std::logic_error);
  EXPECT_THROW(layer_of({10, 1, 8}, 8), std::logic_error);  // channels that are not whole vectors
  EXPECT_THROW(layer_of({16, 8}, 8), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
