#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/losses.hpp"
#include "libtorch/twin/networks.hpp"
#include "libtorch/twin/random_tensor.hpp"
#include "twin/recurrent_coder.hpp"

namespace piae::libtorch {
namespace {

using testing::HasSubstr;

constexpr std::int64_t windows = 3;

torch::Tensor labels() {
  return torch::one_hot(torch::tensor({0, 1, 1}, torch::kInt64), 2).to(torch::kFloat64);
}

twin::TwinOptions small_options(int depth) {
  twin::TwinOptions options;
  options.depth = depth;
  options.width = 6;
  return options;
}

struct Case {
  const char* name;
  twin::TwinVariant variant;
  std::int64_t samples;
};

class Coders : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override { torch::set_num_threads(1); }
  const twin::NetworkShape shape_{GetParam().samples, 2};
  const Networks networks_{GetParam().variant, shape_, small_options(3)};
  ParameterSet parameters_{networks_.specs(), Stream("coders"), torch::kFloat64};
  Stream stream_{"windows"};
  const torch::Tensor x_ = random_tensor(stream_, windows, GetParam().samples);

  [[nodiscard]] torch::Tensor loss() const {
    const torch::Tensor k_and_c = networks_.encode(parameters_, x_);
    return reconstruction_loss(x_, networks_.decode(parameters_, k_and_c, labels()));
  }
};

TEST_P(Coders, MakePositiveParametersAndWindowsOfTheirLength) {
  const torch::Tensor k_and_c = networks_.encode(parameters_, x_ * 100);
  EXPECT_EQ(k_and_c.sizes(), (torch::IntArrayRef{windows, 2}));
  EXPECT_GT(k_and_c.min().item<double>(), 0);
  EXPECT_EQ(networks_.decode(parameters_, k_and_c, labels()).sizes(), x_.sizes());
}

TEST_P(Coders, DecodeEveryPartOfTheirInput) {
  const torch::Tensor one = torch::tensor({{1.0, 2.0}}, torch::kFloat64);
  const torch::Tensor label = labels().narrow(0, 0, 1);
  const torch::Tensor a = networks_.decode(parameters_, one, label);
  const auto differs = [&](const torch::Tensor& k_and_c, const torch::Tensor& other_label) {
    const torch::Tensor b = networks_.decode(parameters_, k_and_c, other_label);
    return (a - b).abs().max().item<double>() > 1e-9;
  };
  EXPECT_TRUE(differs(torch::tensor({{1.5, 2.0}}, torch::kFloat64), label));
  EXPECT_TRUE(differs(torch::tensor({{1.0, 2.5}}, torch::kFloat64), label));
  EXPECT_TRUE(differs(one, labels().narrow(0, 1, 1)));
}

/// Checks that the other windows of a batch do not affect a window's code.
TEST_P(Coders, TreatTheWindowsOfABatchIndependently) {
  const torch::Tensor all = networks_.encode(parameters_, x_);
  const torch::Tensor one = networks_.encode(parameters_, x_.narrow(0, 1, 1));
  EXPECT_LT((all.narrow(0, 1, 1) - one).abs().max().item<double>(), 1e-12);
  const torch::Tensor decoded = networks_.decode(parameters_, all, labels());
  const torch::Tensor alone = networks_.decode(parameters_, one, labels().narrow(0, 1, 1));
  EXPECT_LT((decoded.narrow(0, 1, 1) - alone).abs().max().item<double>(), 1e-12);
}

/// Compares L_Rec's gradient, through decoder, softplus and encoder, with central differences at a
/// few entries of each parameter.
TEST_P(Coders, GradientsOfTheReconstructionLossEqualFiniteDifferences) {
  constexpr double step = 1e-5;
  parameters_.zero_gradients();
  loss().backward();
  const torch::NoGradGuard no_grad;
  const double largest = parameters_.gradients().abs().max().item<double>();
  for (const nets::ParameterSpec& spec : networks_.specs()) {
    if (spec.name.starts_with("net/physics")) continue;
    const torch::Tensor values = parameters_[spec.name].detach().view(-1);
    const torch::Tensor exact = parameters_[spec.name].grad().view(-1);
    EXPECT_GT(exact.abs().max().item<double>(), 0) << spec.name;
    for (int i = 0; i < 3; ++i) {
      const auto at =
          static_cast<std::int64_t>(stream_.below(static_cast<std::size_t>(values.numel())));
      const auto old = values[at].item<double>();
      values[at] = old + step;
      const auto above = loss().item<double>();
      values[at] = old - step;
      const auto below = loss().item<double>();
      values[at] = old;
      EXPECT_NEAR(exact[at].item<double>(), (above - below) / (2 * step), 1e-6 * largest)
          << spec.name << ' ' << at;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Twin, Coders,
                         testing::Values(Case{"Dense", twin::full_model, 20},
                                         Case{"Convolutional", twin::convolutional_model, 48},
                                         Case{"Recurrent", twin::recurrent_model, 96},
                                         Case{"Temporal", twin::temporal_model, 48},
                                         Case{"Transformer", twin::transformer_model, 96}),
                         [](const auto& info) { return info.param.name; });

std::vector<std::string> names_of(const std::vector<nets::ParameterSpec>& specs) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const nets::ParameterSpec& spec : specs) names.push_back(spec.name);
  return names;
}

/// Checks that parts not replaced by Models 2, 4, 5 and the outlook models keep their names, shapes
/// and initial values.
TEST(TwinVariants, DifferInTheirPartOnly) {
  const twin::NetworkShape shape{64, 3};
  const Networks full(twin::full_model, shape, small_options(3));
  const Networks without(twin::without_physics, shape, small_options(3));
  std::vector<std::string> coder = names_of(full.specs());
  std::erase_if(coder, [](const std::string& name) { return name.starts_with("net/physics/"); });
  EXPECT_EQ(names_of(without.specs()), coder);
  EXPECT_EQ(coder.size(), names_of(full.specs()).size() - 6);  // three layers

  const ParameterSet reference(full.specs(), Stream("start"));
  for (const twin::TwinVariant& variant : {twin::convolutional_model, twin::recurrent_model,
                                           twin::temporal_model, twin::transformer_model}) {
    const ParameterSet other(Networks(variant, shape, small_options(3)).specs(), Stream("start"));
    EXPECT_TRUE(reference.values("net/physics/").equal(other.values("net/physics/")));
  }
}

/// Compares a GRU of one unit with a hand calculation (Cho et al. 2014, in LibTorch's form). With
/// all state weights 0: r = s(w_r x), z = s(w_z x), n = tanh(w_n x), h' = (1 - z) n + z h.
TEST(RecurrentCoder, ReadsItsFramesInTurn) {
  const Networks networks(twin::recurrent_model, {64, 2}, small_options(2));
  ParameterSet parameters(networks.specs(), Stream("gru"), torch::kFloat64);
  {
    const torch::NoGradGuard no_grad;
    parameters.values().zero_();
    const auto set = [&](const std::string& name, std::int64_t row, double value) {
      parameters[name].detach()[row][0] = value;
    };
    set("net/encoder/gru0/input_weight", twin::RecurrentCoder::units,
        0.5);  // gate z of unit 0, from sample 0
    set("net/encoder/gru0/input_weight", 2 * twin::RecurrentCoder::units, 1.0);  // candidate n
    set("net/encoder/dense/weight", 0, 1.0);  // k is the last state
  }
  torch::Tensor x = torch::zeros({1, 64}, torch::kFloat64);
  x[0][0] = 0.8;
  x[0][32] = -0.6;
  const auto gate = [](double v) { return 1 / (1 + std::exp(-v)); };
  double h = (1 - gate(0.4)) * std::tanh(0.8);
  h = (1 - gate(-0.3)) * std::tanh(-0.6) + gate(-0.3) * h;
  EXPECT_NEAR(networks.encode(parameters, x)[0][0].item<double>(), std::log1p(std::exp(h)), 1e-12);
}

/// Gives one channel a kernel of ones and a value at the first position only. The output is the
/// value at the samples under the kernel, -2 .. 5 about position 0, cut to the window.
TEST(ConvolutionalCoder, SpreadsAPositionOverItsKernel) {
  const Networks networks(twin::convolutional_model, {16, 2}, small_options(2));
  ParameterSet parameters(networks.specs(), Stream("conv"), torch::kFloat64);
  {
    const torch::NoGradGuard no_grad;
    parameters.values().zero_();
    parameters["net/decoder/dense/weight"].detach()[0][0] = 1.0;  // channel 0, position 0, of k
    parameters["net/decoder/conv0/weight"].detach()[0].fill_(1.0);
  }
  const torch::Tensor k_and_c = torch::tensor({{3.0, 1.0}}, torch::kFloat64);
  const torch::Tensor a = networks.decode(parameters, k_and_c, labels().narrow(0, 0, 1));
  torch::Tensor expected = torch::zeros({1, 16}, torch::kFloat64);
  expected.narrow(1, 0, 6).fill_(3.0);
  EXPECT_TRUE(a.equal(expected)) << a;
}

void expect_usage_error(const twin::TwinVariant& variant, std::int64_t samples, int depth,
                        const std::vector<std::string>& words) {
  try {
    const Networks networks(variant, {samples, 2}, small_options(depth));
    FAIL() << "was not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit(), Exit::usage);
    for (const std::string& word : words) EXPECT_THAT(error.what(), HasSubstr(word));
  }
}

TEST(TwinVariants, NamePossibleWindows) {
  expect_usage_error(twin::convolutional_model, 1000, 4, {"1000", "multiples of 64", "--window"});
  expect_usage_error(twin::convolutional_model, 1024, 7, {"1024", "multiples of 4096", "--depth"});
  expect_usage_error(twin::convolutional_model, 1024, 32, {"--depth"});
  expect_usage_error(twin::convolutional_model, 1024, 1, {"--depth", "2 or more"});
  expect_usage_error(twin::temporal_model, 1000, 3, {"1000", "multiples of 16", "--window"});
  expect_usage_error(twin::temporal_model, 1024, 1, {"--depth", "2 to 10"});
  expect_usage_error(twin::temporal_model, 1024, 11, {"--depth", "2 to 10"});
  expect_usage_error(twin::transformer_model, 1000, 3, {"1000", "multiples of 32", "--window"});
  expect_usage_error(twin::transformer_model, 1024, 1, {"--depth", "2 or more"});
  EXPECT_NO_THROW(Networks(twin::full_model, {1001, 2}, small_options(1)));
  EXPECT_NO_THROW(Networks(twin::convolutional_model, {1024, 2}, small_options(6)));
}

}  // namespace
}  // namespace piae::libtorch
