#include "libtorch/nets/dense.hpp"

#include <gtest/gtest.h>

#include "libtorch/nets/torch.hpp"

namespace piae::libtorch {
namespace {

void set(const ParameterSet& parameters, const std::string& name, const torch::Tensor& values) {
  const torch::NoGradGuard no_grad;
  parameters[name].copy_(values);
}

TEST(DenseChain, AppliesReluBetweenLayersOnly) {
  const ParameterSet parameters(nets::dense_chain_specs("net/a", 2, 2, {2, 2}), Stream("test"));
  set(parameters, "net/a/0/weight", torch::tensor({{1.0, -2.0}, {3.0, 1.0}}));
  set(parameters, "net/a/0/bias", torch::tensor({0.5, -1.0}));
  set(parameters, "net/a/1/weight", torch::tensor({{1.0, 1.0}, {-2.0, -1.0}}));
  set(parameters, "net/a/1/bias", torch::tensor({0.0, 1.0}));
  // x = (1, 2): hidden (-2.5, 4), after ReLU (0, 4); out (4, -3). x = (2, 0): (2.5, 5); (7.5, -9).
  const torch::Tensor out =
      run_dense_chain(parameters, "net/a", torch::tensor({{1.0, 2.0}, {2.0, 0.0}}));
  EXPECT_TRUE(torch::allclose(out, torch::tensor({{4.0, -3.0}, {7.5, -9.0}})));
}

TEST(DenseChain, DoesNotUseLayersOfALongerName) {
  std::vector<nets::ParameterSpec> specs = nets::dense_chain_specs("net/a", 2, 2, {1, 2});
  const auto others = nets::dense_chain_specs("net/ab", 2, 2, {1, 2});
  specs.insert(specs.end(), others.begin(), others.end());
  const ParameterSet parameters(specs, Stream("test"));
  set(parameters, "net/a/0/weight", torch::eye(2));
  set(parameters, "net/a/0/bias", torch::zeros(2));
  const torch::Tensor x = torch::tensor({{1.0, -2.0}});
  EXPECT_TRUE(torch::equal(run_dense_chain(parameters, "net/a", x), x));
}

}  // namespace
}  // namespace piae::libtorch
