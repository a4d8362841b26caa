// Compares encoders and decoders with sequence layers in our kernels and in LibTorch, with the same
// parameters.

#include <gtest/gtest.h>

#include <cmath>

#include "libtorch/nets/adam.hpp"
#include "libtorch/nets/parameters.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/convolutional_coder.hpp"
#include "libtorch/twin/recurrent_coder.hpp"
#include "libtorch/twin/temporal_coder.hpp"
#include "libtorch/twin/transformer_coder.hpp"
#include "nets/parameters.hpp"
#include "twin/specs.hpp"

namespace piae::libtorch {
namespace {

using nets::Rows;

constexpr twin::NetworkShape coded_shape{.samples = 192, .classes = 3};

twin::TwinOptions of_depth(int depth) {
  twin::TwinOptions options;
  options.depth = depth;
  return options;
}

template <class T>
constexpr torch::Dtype dtype = std::is_same_v<T, double> ? torch::kFloat64 : torch::kFloat32;

template <class T>
torch::Tensor random_rows(const std::string& name, std::int64_t rows, std::int64_t columns) {
  Stream stream(name);
  std::vector<double> values;
  for (std::int64_t i = 0; i < rows * columns; ++i) values.push_back(stream.normal(0, 1));
  return torch::tensor(values, torch::kFloat64).view({rows, columns}).to(dtype<T>);
}

template <class T>
void put_rows(const torch::Tensor& from, Rows<T> to, std::int64_t first = 0) {
  const auto values = from.detach().contiguous();
  for (std::int64_t i = 0; i < from.size(0); ++i) {
    std::copy_n(values.template data_ptr<T>() + i * from.size(1), from.size(1), to.row(first + i));
  }
}

template <class T>
torch::Tensor tensor_of_rows(Rows<const T> rows, std::int64_t count, std::int64_t columns) {
  std::vector<T> values;
  for (std::int64_t i = 0; i < count; ++i) {
    values.insert(values.end(), rows.row(i), rows.row(i) + columns);
  }
  return torch::tensor(values, dtype<T>).view({count, columns});
}

double distance(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>() / b.abs().max().item<double>();
}

/// One network of a coder in both implementations.
template <class T, class Mine, class Theirs>
struct BothCoders {
  BothCoders(int depth, bool is_encoder, std::int64_t most_rows)
      : encodes(is_encoder),
        name((encodes ? twin::encoder_name : twin::decoder_name) + "/"),
        theirs(coded_shape, of_depth(depth)),
        set(theirs.specs(), Stream("initial"), dtype<T>),
        flat(std::make_shared<nets::Parameters<T>>(theirs.specs(), Stream("initial"))) {
    const Mine mine(coded_shape, of_depth(depth));
    network = encodes ? mine.template make_encoder<T>(flat, most_rows)
                      : mine.template make_decoder<T>(flat, most_rows);
  }

  [[nodiscard]] std::int64_t inputs() const {
    return encodes ? coded_shape.samples : 2 + coded_shape.classes;
  }
  [[nodiscard]] std::int64_t outputs() const { return encodes ? 2 : coded_shape.samples; }
  [[nodiscard]] torch::Tensor run(const torch::Tensor& x) const {
    return encodes ? theirs.encode(set, x) : theirs.decode(set, x);
  }

  [[nodiscard]] torch::Tensor kept(typename nets::Parameters<T>::Kept which) const {
    std::vector<T> all;
    for (const auto& p : flat->parameters()) {
      if (!p.spec.name.starts_with(name)) continue;
      for (std::int64_t i = 0; i < p.rows; ++i) {
        const T* const row = flat->data(which) + p.begin + i * p.held_columns;
        all.insert(all.end(), row, row + p.columns);
      }
    }
    return torch::tensor(all, dtype<T>);
  }

  bool encodes;
  std::string name;
  Theirs theirs;
  ParameterSet set;
  std::shared_ptr<nets::Parameters<T>> flat;
  std::unique_ptr<nets::Network<T>> network;
};

/// Compares outputs, input gradients of the second of two signals, and parameter gradients of the
/// first signal with their norm.
template <class T, class Mine, class Theirs>
void expect_the_same_gradients(int depth, bool encodes, double tolerance) {
  using Kept = typename nets::Parameters<T>::Kept;
  constexpr std::int64_t rows = 5;
  BothCoders<T, Mine, Theirs> both(depth, encodes, 2 * rows);
  const torch::Tensor x = random_rows<T>("x", rows, both.inputs()).requires_grad_();
  const torch::Tensor first = random_rows<T>("first", rows, both.outputs());
  const torch::Tensor second = random_rows<T>("second", rows, both.outputs());
  put_rows<T>(x, both.network->input());
  const torch::Tensor y = both.run(x);
  EXPECT_LT(distance(tensor_of_rows<T>(both.network->forward(rows), rows, both.outputs()), y),
            tolerance);

  put_rows<T>(first, both.network->output_gradient());
  put_rows<T>(second, both.network->output_gradient(), rows);
  const torch::Tensor by_x =
      tensor_of_rows<T>(both.network->backward(rows, 2, {rows, rows}), rows, both.inputs());
  EXPECT_LT(distance(by_x, torch::autograd::grad({(y * second).sum()}, {x}, {}, true)[0]),
            tolerance);

  std::vector<torch::Tensor> each = torch::autograd::grad(
      {(y * first).sum()}, both.set.with_prefix(both.name), {}, /*retain_graph=*/true);
  for (torch::Tensor& gradient : each) gradient = gradient.reshape({-1});
  const torch::Tensor expected = torch::cat(each);
  const double squares = expected.to(torch::kFloat64).square().sum().template item<double>();
  EXPECT_NEAR(both.network->squared_norm(), squares, 2 * tolerance * squares);
  both.network->take(nets::AdamStep(1, 1e-3), 0.5);
  EXPECT_LT(distance(20 * both.kept(Kept::first_moment), expected), tolerance);
}

/// Takes ten steps of Adam towards random outputs in both implementations.
template <class T, class Mine, class Theirs>
void expect_the_same_steps(bool encodes, double tolerance) {
  using Kept = typename nets::Parameters<T>::Kept;
  constexpr std::int64_t rows = 4;
  BothCoders<T, Mine, Theirs> both(3, encodes, rows);
  const torch::Tensor x = random_rows<T>("x", rows, both.inputs());
  const torch::Tensor target = random_rows<T>("target", rows, both.outputs());
  Adam adam(both.set.values(both.name), both.set.gradients(both.name));
  for (int t = 1; t <= 10; ++t) {
    both.set.zero_gradients();
    (0.5 * (both.run(x) - target).square()).sum().backward();
    adam.step(1e-3);
    put_rows<T>(x, both.network->input());
    put_rows<T>(tensor_of_rows<T>(both.network->forward(rows), rows, both.outputs()) - target,
                both.network->output_gradient());
    both.network->backward(rows, 1, nets::no_rows);
    both.network->take(nets::AdamStep(t, 1e-3), 1);
  }
  EXPECT_LT(distance(both.kept(Kept::value), both.set.values(both.name)), tolerance);
}

template <class Mine, class Theirs>
void expect_the_same() {
  torch::set_num_threads(1);
  for (const bool encodes : {true, false}) {
    for (const int depth : {2, 3, 4}) {
      SCOPED_TRACE((encodes ? "encoder of depth " : "decoder of depth ") + std::to_string(depth));
      expect_the_same_gradients<double, Mine, Theirs>(depth, encodes, 1e-12);
      expect_the_same_gradients<float, Mine, Theirs>(depth, encodes, 1e-5);
    }
    expect_the_same_steps<double, Mine, Theirs>(encodes, 1e-10);
    // Adam divides by the root of its second moment. Rounding of a gradient near zero therefore
    // moves a weight as much as a large gradient does.
    expect_the_same_steps<float, Mine, Theirs>(encodes, 1e-3);
  }
}

TEST(SequenceCoders, ConvolutionsMatchLibtorch) {
  expect_the_same<twin::ConvolutionalCoder, ConvolutionalCoder>();
}

TEST(SequenceCoders, RecurrentUnitsMatchLibtorch) {
  expect_the_same<twin::RecurrentCoder, RecurrentCoder>();
}

TEST(SequenceCoders, TemporalNetworkMatchesLibtorch) {
  expect_the_same<twin::TemporalCoder, TemporalCoder>();
}

TEST(SequenceCoders, TransformerMatchesLibtorch) {
  expect_the_same<twin::TransformerCoder, TransformerCoder>();
}

}  // namespace
}  // namespace piae::libtorch
