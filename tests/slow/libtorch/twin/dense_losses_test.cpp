// Compares our losses and gradients with LibTorch's in double precision. losses_test.cpp compares
// LibTorch's with finite differences.

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "libtorch/nets/torch.hpp"
#include "libtorch/twin/losses.hpp"
#include "twin/losses.hpp"

namespace piae::libtorch {
namespace {

using Array = nets::RowArray<double>;

constexpr double tolerance = 1e-9;

Array random_array(const std::string& name, std::int64_t rows, std::int64_t columns,
                   double scale = 1) {
  Stream stream(name);
  Array array(rows, columns);
  for (double& x : array.reshaped()) x = scale * stream.normal(0, 1);
  return array;
}

torch::Tensor tensor_of(const Array& array) {
  return torch::from_blob(const_cast<double*>(array.data()), {array.rows(), array.cols()},
                          torch::kFloat64)
      .clone()
      .requires_grad_();
}

void expect_equal(const Array& mine, const torch::Tensor& theirs) {
  const torch::Tensor own = tensor_of(mine).detach();
  ASSERT_EQ(own.sizes(), theirs.sizes());
  EXPECT_LT((own - theirs).abs().max().item<double>(),
            tolerance * theirs.abs().max().item<double>());
}

torch::Tensor gradient(const torch::Tensor& loss, const torch::Tensor& by) {
  return torch::autograd::grad({loss}, {by}, {}, /*retain_graph=*/true)[0];
}

TEST(BatchMmdAgainstLibtorch, MatchesLibtorchWithItsGradients) {
  const Array x = random_array("x", 3, 17);
  const Array y = random_array("y", 5, 17, 1.5);
  Array by_x = Array::Ones(3, 17);  // add_batch_mmd adds to this
  Array by_y = Array::Zero(5, 17);
  const double value = twin::add_batch_mmd<double>(x, y, &by_x, by_y);
  const torch::Tensor tx = tensor_of(x);
  const torch::Tensor ty = tensor_of(y);
  const torch::Tensor mmd = batch_mmd(tx, ty);
  EXPECT_NEAR(value, mmd.item<double>(), tolerance);
  expect_equal(by_x - 1, gradient(mmd, tx));
  expect_equal(by_y, gradient(mmd, ty));
}

class TwinLossesAgainstLibtorch : public testing::TestWithParam<twin::LossInterpretation> {};

TEST_P(TwinLossesAgainstLibtorch, ReconstructionMatchesLibtorch) {
  const Array x = random_array("x", 4, 33);
  const Array a = random_array("a", 4, 33, 0.7);
  const twin::LossOf<double> mine = twin::reconstruction_loss<double>(x, a, GetParam());
  const torch::Tensor ta = tensor_of(a);
  const torch::Tensor theirs = reconstruction_loss(tensor_of(x), ta, GetParam());
  EXPECT_NEAR(mine.value, theirs.item<double>(), tolerance * mine.value);
  expect_equal(mine.by_acceleration, gradient(theirs, ta));
}

TEST_P(TwinLossesAgainstLibtorch, DifferentialMatchesLibtorch) {
  const twin::BatchMotion<double> motion{random_array("u", 4, 40), random_array("v", 4, 40),
                                         random_array("a", 4, 40)};
  for (const auto derivatives : {twin::Derivatives::central, twin::Derivatives::spectral}) {
    const twin::Stencil stencil = twin::stencil_of(derivatives);
    const twin::LossOf<double> mine =
        twin::differential_loss<double>(motion, 0.8, stencil, GetParam());
    const torch::Tensor u = tensor_of(motion.displacement);
    const torch::Tensor v = tensor_of(motion.velocity);
    const torch::Tensor a = tensor_of(motion.acceleration);
    const torch::Tensor theirs = differential_loss({u, v}, a, 0.8, stencil, GetParam());
    EXPECT_NEAR(mine.value, theirs.item<double>(), tolerance * mine.value);
    expect_equal(mine.by_displacement, gradient(theirs, u));
    expect_equal(mine.by_velocity, gradient(theirs, v));
    expect_equal(mine.by_acceleration, gradient(theirs, a));
  }
}

/// Takes the contacts of two classes. Displacements are so large that balls lift off in some
/// samples.
void expect_twin_loss_of_libtorch(const std::vector<twin::Contact>& contacts,
                                  const twin::LossInterpretation& reading) {
  twin::Physics physics;
  physics.mass_kg = 1.3;
  physics.load_n = 1000;
  physics.contact_n_per_m15 = 8.58e9;
  physics.omega_0 = 1e4;
  physics.damping = 0.01;
  physics.contact = contacts;
  physics.acceleration_m_s2 = {300.0, 500.0};
  const std::vector<std::int32_t> labels{0, 1, 1};
  const twin::BatchMotion<double> motion{random_array("u", 3, 20), random_array("v", 3, 20),
                                         random_array("a", 3, 20)};
  Array k_and_c(3, 2);
  k_and_c << 1.0, 5.0, 0.4, 2.0, 2.0, 0.1;
  const twin::LossOf<double> mine =
      twin::twin_loss<double>(k_and_c, motion, labels, physics, reading);

  const torch::Tensor kc = tensor_of(k_and_c);
  const torch::Tensor u = tensor_of(motion.displacement);
  const torch::Tensor v = tensor_of(motion.velocity);
  const torch::Tensor a = tensor_of(motion.acceleration);
  const torch::Tensor theirs = twin_loss(
      kc, a, {u, v}, batch_physics(physics, torch::tensor(labels, torch::kInt64), torch::kFloat64),
      physics, reading);
  EXPECT_NEAR(mine.value, theirs.item<double>(), tolerance * mine.value);
  expect_equal(mine.by_displacement, gradient(theirs, u));
  expect_equal(mine.by_velocity, gradient(theirs, v));
  expect_equal(mine.by_acceleration, gradient(theirs, a));
  expect_equal(mine.by_k_and_c, gradient(theirs, kc));
}

TEST_P(TwinLossesAgainstLibtorch, TwinMatchesLibtorch) {
  expect_twin_loss_of_libtorch(
      {{.outside_m = 0, .inside_m = 2e-6}, {.outside_m = 0, .inside_m = 3e-6}}, GetParam());
}

TEST_P(TwinLossesAgainstLibtorch, TwinMatchesLibtorchDuringAPassage) {
  std::vector<double> passing(20, 0.0);
  passing[4] = 0.3;
  passing[5] = 1;
  expect_twin_loss_of_libtorch(
      {{.outside_m = 2e-6, .inside_m = 3e-6, .at_rest = 0, .passing = passing},
       {.outside_m = 2e-6, .inside_m = 6e-6, .at_rest = 0.2}},
      GetParam());
}

INSTANTIATE_TEST_SUITE_P(Readings, TwinLossesAgainstLibtorch,
                         testing::Values(twin::LossInterpretation{},
                                         twin::LossInterpretation{
                                             .squares = twin::Squares::sum,
                                             .mmd = twin::Mmd::root,
                                             .residual = twin::Residual::absolute}),
                         [](const auto& info) {
                           return info.index == 0 ? "MeanSquares" : "SumsRootsAndAbsoluteValues";
                         });

}  // namespace
}  // namespace piae::libtorch
