// The gradients of networks of convolutions, written by hand, against finite differences in double
// precision. That they are those of LibTorch, too: tests/libtorch/nets/convolutional_chain_test.cpp

#include "nets/convolutional_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "nets/convolution_example.hpp"
#include "support/differences.hpp"

namespace piae::nets {
namespace {

class ConvolutionNetworks : public testing::TestWithParam<Convolutions> {
 protected:
  using Held = Parameters<double>::Kept;
  static constexpr std::int64_t rows = 3;

  RowArray<double> forward(const RowArray<double>& x) {
    put(x, network_->input());
    return copied(network_->forward(x.rows()), x.rows(), example_.outputs());
  }
  /// Of the sum of all outputs times `slope`.
  double value() { return (forward(x_) * slope_).sum(); }

  /// The gradient that the parameters follow: ten times Adam's first moment after the first step.
  std::vector<double> followed() {
    network_->take(AdamStep(1, 0), 1);
    std::vector<double> gradient = held(*parameters_, Held::first_moment);
    for (double& g : gradient) g *= 10;
    return gradient;
  }

  static void expect_near(const std::vector<double>& mine, const std::vector<double>& expected) {
    ASSERT_EQ(mine.size(), expected.size());
    double largest = 0;
    for (const double x : expected) largest = std::max(largest, std::abs(x));
    EXPECT_GT(largest, 1e-3);
    for (std::size_t i = 0; i < mine.size(); ++i) {
      EXPECT_NEAR(mine[i], expected[i], 1e-7 * largest) << i;
    }
  }

  std::vector<double> differences_by_parameters() {
    std::vector<double> all;
    for (const auto& p : parameters_->parameters()) {
      for (std::int64_t i = 0; i < p.rows; ++i) {
        for (std::int64_t j = 0; j < p.columns; ++j) {
          double& number = parameters_->data(Held::value)[p.begin + i * p.held_columns + j];
          all.push_back(central_difference(number, 1e-6, [&] { return value(); }));
        }
      }
    }
    return all;
  }
  std::vector<double> differences_by_input() {
    std::vector<double> all;
    for (double& number : x_.reshaped<Eigen::RowMajor>()) {
      all.push_back(central_difference(number, 1e-6, [&] { return value(); }));
    }
    return all;
  }

  const ConvolutionExample example_{GetParam()};
  std::shared_ptr<Parameters<double>> parameters_ =
      std::make_shared<Parameters<double>>(example_.specs, Stream("initial"));
  std::unique_ptr<Network<double>> network_ = example_.network(parameters_, 2 * rows);
  RowArray<double> x_ = drawn("x", rows, example_.inputs());
  RowArray<double> slope_ = drawn("slope", rows, example_.outputs());
};

TEST_P(ConvolutionNetworks, HaveTheGradientsOfFiniteDifferences) {
  const std::vector<double> expected = differences_by_parameters();
  const std::vector<double> expected_by_input = differences_by_input();
  value();
  put(slope_, network_->output_gradient());
  const RowArray<double> by_input =
      copied(network_->backward(rows, 1, {0, rows}), rows, example_.inputs());
  expect_near({by_input.data(), by_input.data() + by_input.size()}, expected_by_input);
  double squares = 0;
  for (const double g : expected) squares += g * g;
  EXPECT_NEAR(network_->squared_norm(), squares, 1e-6 * squares);
  expect_near(followed(), expected);
}

TEST_P(ConvolutionNetworks, PropagateTwoSignalsOfWhichTheParametersFollowTheFirst) {
  const std::vector<double> expected = differences_by_parameters();
  const RowArray<double> second = drawn("second", rows, example_.outputs());
  const auto take_back = [&](const RowArray<double>& signal) {
    value();
    put(signal, network_->output_gradient());
    return copied(network_->backward(rows, 1, {0, rows}), rows, example_.inputs());
  };
  const RowArray<double> alone = take_back(second);
  value();
  put(slope_, network_->output_gradient());
  put(second, network_->output_gradient().from(rows));
  const RowArray<double> by_input =
      copied(network_->backward(rows, 2, {rows, rows}), rows, example_.inputs());
  EXPECT_TRUE((by_input == alone).all());
  expect_near(followed(), expected);
}

TEST_P(ConvolutionNetworks, GiveForARowWhatDoesNotDependOnThoseBesideIt) {
  const RowArray<double> all = forward(x_);
  for (std::int64_t i = 0; i < rows; ++i) {
    EXPECT_TRUE((forward(x_.row(i)) == all.row(i)).all()) << i;
  }
}

TEST_P(ConvolutionNetworks, KeepWhatFillsRowsUpAtZero) {
  for (int t = 1; t <= 3; ++t) {
    value();
    put(slope_, network_->output_gradient());
    network_->backward(rows, 1, {0, rows});
    network_->take(AdamStep(t, 1e-2), 1);
  }
  for (const Held kept : {Held::value, Held::first_moment, Held::second_moment}) {
    const std::vector<double> filling = held(*parameters_, kept, true);
    EXPECT_GT(filling.size(), 0U);
    for (const double x : filling) EXPECT_EQ(x, 0);
  }
}

// What stands before and after a signal in memory is read as the zeros that a convolution has
// there.
TEST_P(ConvolutionNetworks, GiveTheSameAfterALargerBatchAndItsGradients) {
  const RowArray<double> x = drawn("other", 1, example_.inputs());
  const RowArray<double> before = forward(x);
  value();
  put(slope_, network_->output_gradient());
  network_->backward(rows, 1, {0, rows});
  EXPECT_TRUE((forward(x) == before).all());
}

TEST_P(ConvolutionNetworks, HaveNoRoomForMoreRowsThanTheyWereMadeFor) {
  EXPECT_THROW(network_->forward(2 * rows + 1), std::logic_error);
  EXPECT_THROW(network_->backward(rows, 3, no_rows), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(Nets, ConvolutionNetworks,
                         testing::Values(Convolutions::strided, Convolutions::transposed,
                                         Convolutions::encoder, Convolutions::decoder),
                         [](const auto& info) { return name_of(info.param); });

TEST(ConvolutionalChain, RefusesWhatIsNoStridedConvolution) {
  const auto chain_of = [](std::vector<std::int64_t> weight, std::int64_t length) {
    const std::int64_t outputs = weight[0];
    const auto parameters = std::make_shared<Parameters<double>>(
        std::vector<ParameterSpec>{{"net/conv0/weight", std::move(weight)},
                                   {"net/conv0/bias", {outputs}}},
        Stream("test"));
    return ConvolutionalChain<double>(parameters, "net", ConvolutionKind::strided, length, 1);
  };
  EXPECT_NO_THROW(chain_of({16, 1, 8}, 8));
  EXPECT_THROW(chain_of({16, 1, 8}, 10), std::logic_error);  // no multiple of 4
  EXPECT_THROW(chain_of({16, 1, 6}, 9), std::logic_error);   // of an odd stride
  EXPECT_THROW(chain_of({16, 1, 9}, 8), std::logic_error);
  EXPECT_THROW(chain_of({10, 1, 8}, 8), std::logic_error);  // no whole vectors of channels
  EXPECT_THROW(chain_of({16, 8}, 8), std::logic_error);
}

TEST(ConvolutionalChain, RefusesANameThatNoParameterHas) {
  const ConvolutionExample example(Convolutions::strided);
  const auto parameters = std::make_shared<Parameters<double>>(example.specs, Stream("initial"));
  EXPECT_THROW(ConvolutionalChain<double>(parameters, "another", ConvolutionKind::strided, 24, 1),
               std::logic_error);
}

}  // namespace
}  // namespace piae::nets
