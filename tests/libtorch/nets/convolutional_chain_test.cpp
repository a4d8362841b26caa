// Networks of convolutions by hand against torch::conv1d and torch::conv_transpose1d.

#include "nets/convolutional_chain.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/dense.hpp"
#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"
#include "nets/convolution_example.hpp"

namespace piae::libtorch {
namespace {

using nets::AdamStep;
using nets::Convolutions;

/// The network in T, with LibTorch's parameters of the same values beside it.
template <class T>
struct Both {
  using Kept = typename nets::Parameters<T>::Kept;
  static constexpr torch::Dtype dtype =
      std::is_same_v<T, double> ? torch::kFloat64 : torch::kFloat32;

  Both(Convolutions which, std::int64_t most_rows)
      : example(which),
        set(example.specs, Stream("initial"), dtype),
        parameters(std::make_shared<nets::Parameters<T>>(example.specs, Stream("initial"))),
        network(example.network(parameters, most_rows)) {}

  /// By LibTorch: rows [time, channel], as ours has them, to such rows, or from or to a code.
  [[nodiscard]] torch::Tensor run(const torch::Tensor& input) const {
    torch::Tensor x = input;
    if (example.which == Convolutions::decoder) {
      x = torch::relu(run_dense(set, "net/dense", x))
              .view({-1, nets::ConvolutionExample::inner_channels,
                     nets::ConvolutionExample::inner_length});
    } else {
      const std::int64_t channels = example.is_encoding()
                                        ? nets::ConvolutionExample::channels
                                        : nets::ConvolutionExample::inner_channels;
      x = x.view({x.size(0), -1, channels}).transpose(1, 2);
    }
    for (const std::string layer : {"net/conv0", "net/conv1"}) {
      const torch::Tensor& weight = set[layer + "/weight"];
      const torch::Tensor& bias = set[layer + "/bias"];
      const std::int64_t stride = weight.size(2) / 2;
      if (layer == "net/conv1") x = torch::relu(x);
      x = example.is_encoding() ? torch::conv1d(x, weight, bias, stride, stride / 2)
                                : torch::conv_transpose1d(x, weight, bias, stride, stride / 2);
    }
    if (example.which == Convolutions::encoder) {
      return run_dense(set, "net/dense", torch::relu(x).flatten(1));
    }
    return x.transpose(1, 2).flatten(1);
  }

  [[nodiscard]] torch::Tensor tensor(std::vector<T> values) const {
    return torch::tensor(std::vector<T>(values), dtype);
  }
  [[nodiscard]] torch::Tensor drawn(const std::string& name, std::int64_t rows,
                                    std::int64_t columns) const {
    const nets::RowArray<double> numbers = nets::drawn(name, rows, columns);
    return tensor({numbers.data(), numbers.data() + numbers.size()}).view({rows, columns});
  }
  static void put(const torch::Tensor& from, nets::Rows<T> to) {
    const torch::Tensor whole = from.detach().contiguous();
    nets::put(nets::RowArray<T>(Eigen::Map<const nets::RowArray<T>>(whole.data_ptr<T>(),
                                                                    whole.size(0), whole.size(1))),
              to);
  }
  [[nodiscard]] torch::Tensor taken(nets::Rows<const T> from, std::int64_t rows,
                                    std::int64_t columns) const {
    const nets::RowArray<T> numbers = nets::copied(from, rows, columns);
    return tensor({numbers.data(), numbers.data() + numbers.size()}).view({rows, columns});
  }
  [[nodiscard]] torch::Tensor forward(const torch::Tensor& x) {
    put(x, network->input());
    return taken(network->forward(x.size(0)), x.size(0), example.outputs());
  }

  nets::ConvolutionExample example;
  ParameterSet set;
  std::shared_ptr<nets::Parameters<T>> parameters;
  std::unique_ptr<nets::Network<T>> network;
};

double difference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>() / b.abs().max().item<double>();
}

class ConvolutionsBesideLibtorch
    : public testing::TestWithParam<std::tuple<Convolutions, std::int64_t>> {
 protected:
  template <class T>
  static void expect_the_same(double tolerance) {
    const auto [which, rows] = GetParam();
    Both<T> both(which, 2 * rows);
    const auto& example = both.example;
    const torch::Tensor x = both.drawn("x", rows, example.inputs()).requires_grad_();
    const torch::Tensor followed = both.drawn("followed", rows, example.outputs());
    const torch::Tensor passed = both.drawn("passed", rows, example.outputs());
    const torch::Tensor y = both.run(x);
    EXPECT_LT(difference(both.forward(x), y), tolerance);

    both.put(torch::cat({followed, passed}), both.network->output_gradient());
    const torch::Tensor by_x =
        both.taken(both.network->backward(rows, 2, {rows, rows}), rows, example.inputs());
    EXPECT_LT(difference(by_x, torch::autograd::grad({(y * passed).sum()}, {x}, {}, true)[0]),
              tolerance);

    both.set.zero_gradients();
    (y * followed).sum().backward();
    const torch::Tensor expected = both.set.gradients();
    const auto squares = expected.square().sum().template item<double>();
    EXPECT_NEAR(both.network->squared_norm(), squares, tolerance * squares);
    // Adam's first moment after its first step is a tenth of the gradient.
    both.network->take(AdamStep(1, 1e-3), 0.5);
    EXPECT_LT(
        difference(10 * both.tensor(nets::held(*both.parameters, Both<T>::Kept::first_moment)),
                   0.5 * expected),
        tolerance);
  }
};

TEST_P(ConvolutionsBesideLibtorch, AreTheSameInDoublePrecision) { expect_the_same<double>(1e-12); }

TEST_P(ConvolutionsBesideLibtorch, AreTheSameInSinglePrecision) { expect_the_same<float>(1e-5); }

// A batch of one, and one that is no multiple of anything.
INSTANTIATE_TEST_SUITE_P(
    Nets, ConvolutionsBesideLibtorch,
    testing::Combine(testing::Values(Convolutions::strided, Convolutions::transposed,
                                     Convolutions::encoder, Convolutions::decoder),
                     testing::Values(1, 7)),
    [](const auto& info) {
      return name_of(std::get<0>(info.param)) + std::to_string(std::get<1>(info.param));
    });

class TrainedConvolutions : public testing::TestWithParam<Convolutions> {};

TEST_P(TrainedConvolutions, TakeTheStepsOfAdam) {
  constexpr std::int64_t rows = 5;
  Both<double> both(GetParam(), rows);
  const torch::Tensor x = both.drawn("x", rows, both.example.inputs());
  const torch::Tensor target = both.drawn("target", rows, both.example.outputs());
  Adam adam(both.set.values(), both.set.gradients());
  for (int t = 1; t <= 5; ++t) {
    both.set.zero_gradients();
    (0.5 * (both.run(x) - target).square()).sum().backward();
    adam.step(1e-3);
    Both<double>::put(both.forward(x) - target, both.network->output_gradient());
    both.network->backward(rows, 1, nets::no_rows);
    both.network->take(AdamStep(t, 1e-3), 1);
  }
  const torch::Tensor mine =
      both.tensor(nets::held(*both.parameters, nets::Parameters<double>::Kept::value));
  EXPECT_LT(difference(mine, both.set.values().detach()), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Nets, TrainedConvolutions,
                         testing::Values(Convolutions::strided, Convolutions::transposed,
                                         Convolutions::encoder, Convolutions::decoder),
                         [](const auto& info) { return name_of(info.param); });

}  // namespace
}  // namespace piae::libtorch
