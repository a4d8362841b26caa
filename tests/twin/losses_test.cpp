// Compares the twin's losses and hand-written gradients with closed forms and finite differences.

#include "twin/losses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "support/differences.hpp"
#include "support/random_array.hpp"
#include "twin/example_physics.hpp"

namespace piae::twin {
namespace {

using Array = RowArray<double>;
using Motion = BatchMotion<double>;
using Loss = LossOf<double>;

const Stencil central = stencil_of(Derivatives::central);

Motion random_motion(std::int64_t rows, std::int64_t columns) {
  return {random_array("u", rows, columns), random_array("v", rows, columns),
          random_array("a", rows, columns)};
}

/// Expects the gradient to equal central differences of the value in every number of `x`, relative
/// to the largest. `value` reads `x`.
void expect_gradient(const Array& gradient, Array& x, const std::function<double()>& value,
                     double tolerance = 1e-7) {
  ASSERT_EQ(gradient.rows(), x.rows());
  ASSERT_EQ(gradient.cols(), x.cols());
  const double largest = gradient.abs().maxCoeff();
  EXPECT_GT(largest, 0);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(gradient.data()[i], central_difference(x.data()[i], 1e-5, value),
                tolerance * largest)
        << i;
  }
}

double mmd(const Array& x, const Array& y) {
  Array unused = Array::Zero(y.rows(), y.cols());
  return add_batch_mmd<double>(x, y, nullptr, unused);
}

TEST(BatchMmd, EqualsTheHandWorkedValue) {
  // Pooled points 0, 1 | 2: squared distances 1, 4, 1, mean over the 6 ordered pairs 2, b = 0.5.
  Array x(2, 1);
  x << 0, 1;
  Array y(1, 1);
  y << 2;
  double expected = 0;
  for (const double b : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    const double near = std::exp(-1 / b);
    const double far = std::exp(-4 / b);
    expected += (2 + 2 * near) / 4 + 1 - 2 * (far + near) / 2;
  }
  EXPECT_NEAR(mmd(x, y), expected, 1e-12);
}

TEST(BatchMmd, AddsItsGradientsToExistingOnes) {
  Array x = random_array("x", 3, 5);
  Array y = random_array("y", 4, 5);
  Array by_x = Array::Ones(3, 5);
  Array by_y = Array::Ones(4, 5);
  add_batch_mmd<double>(x, y, &by_x, by_y);
  const auto value = [&] { return mmd(x, y); };
  expect_gradient(by_x - 1, x, value);
  expect_gradient(by_y - 1, y, value);
}

TEST(BatchMmd, IsZeroAndFlatForEqualWindows) {
  const Array x = Array::Constant(2, 8, 0.3);
  Array by_y = Array::Zero(2, 8);
  EXPECT_NEAR(add_batch_mmd<double>(x, x, nullptr, by_y), 0, 1e-12);
  // Each pull is as large as one over the bandwidth; their sum is 0 except for rounding.
  EXPECT_LT(by_y.abs().maxCoeff() * mmd_least_bandwidth, 1e-15);
}

TEST(ReconstructionLoss, IsMeanSquareAndMmd) {
  const Array x = random_array("x", 4, 8);
  const Array a = random_array("a", 4, 8);
  EXPECT_NEAR(reconstruction_loss<double>(x, a).value, (x - a).square().mean() + mmd(x, a), 1e-12);
}

TEST(ReconstructionLoss, HasTheGradientOfFiniteDifferences) {
  const Array x = random_array("x", 4, 6);
  Array a = random_array("a", 4, 6);
  expect_gradient(reconstruction_loss<double>(x, a).by_acceleration, a,
                  [&] { return reconstruction_loss<double>(x, a).value; });
}

TEST(DifferentialLoss, VanishesForAMotionThatDiffersByDiscretisationOnly) {
  // u = -cos(w t)/w^2, v = sin(w t)/w, a = cos(w t): the differences err by (w h)^2 / 12 and / 6.
  constexpr double step = 0.01;
  constexpr double omega = 2.0;
  Motion motion{Array(3, 64), Array(3, 64), Array(3, 64)};
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index t = 0; t < 64; ++t) {
      const double angle = omega * step * static_cast<double>(t) + static_cast<double>(i);
      motion.acceleration(i, t) = std::cos(angle);
      motion.displacement(i, t) = -std::cos(angle) / (omega * omega);
      motion.velocity(i, t) = std::sin(angle) / omega;
    }
  }
  EXPECT_LT(differential_loss<double>(motion, step, central).value, 1e-6);
  motion.displacement *= 1.1;
  EXPECT_GT(differential_loss<double>(motion, step, central).value, 1e-3);
}

TEST(DifferentialLoss, HasTheGradientsOfFiniteDifferences) {
  constexpr double step = 0.8;
  Motion motion = random_motion(3, 8);
  const Loss loss = differential_loss<double>(motion, step, central);
  const auto value = [&] { return differential_loss<double>(motion, step, central).value; };
  expect_gradient(loss.by_displacement, motion.displacement, value);
  expect_gradient(loss.by_velocity, motion.velocity, value);
  expect_gradient(loss.by_acceleration, motion.acceleration, value);
}

TEST(DifferentialLoss,
     HasTheGradientsOfFiniteDifferencesAlsoAsRootsAndSumsOverSpectralDerivatives) {
  constexpr double step = 0.8;
  constexpr LossInterpretation interpretation{.squares = Squares::sum, .mmd = Mmd::root};
  const Stencil spectral = stencil_of(Derivatives::spectral);
  Motion motion = random_motion(3, 36);
  const Loss loss = differential_loss<double>(motion, step, spectral, interpretation);
  const auto value = [&] {
    return differential_loss<double>(motion, step, spectral, interpretation).value;
  };
  expect_gradient(loss.by_displacement, motion.displacement, value);
  expect_gradient(loss.by_velocity, motion.velocity, value);
  expect_gradient(loss.by_acceleration, motion.acceleration, value);
}

TEST(ReconstructionLoss, SupportsSumsAndRoots) {
  const Array x = random_array("x", 4, 8);
  const Array a = random_array("a", 4, 8);
  EXPECT_NEAR(reconstruction_loss<double>(x, a, {.squares = Squares::sum, .mmd = Mmd::root}).value,
              (x - a).square().sum() / 4 + std::sqrt(mmd(x, a)), 1e-12);
}

TEST(ReconstructionLoss, IsFlatForEqualWindowsAlsoAsARoot) {
  const Array x = random_array("x", 2, 8);
  const Array nearly = x + 1e-8 * random_array("difference", 2, 8);
  const Loss loss = reconstruction_loss<double>(x, nearly, {.mmd = Mmd::root});
  EXPECT_NEAR(loss.value, std::sqrt(mmd_least_squared), 1e-9);
  // The rest is the slope of the squared error, which is as small as the difference.
  EXPECT_LT(loss.by_acceleration.abs().maxCoeff(), 1e-8);
}

TEST(TwinLoss, VanishesForAFreeDampedOscillation) {
  // Without contact eq. 13 about its equilibrium is a + d c v + k u = 0, solved by
  // exp(-b t) cos(w t).
  Physics physics = example_physics();
  physics.contact_n_per_m15 = 0;
  constexpr double k = 3.2;
  constexpr double c = 6.0;
  const double b = physics.damping * c / 2;
  const double w = std::sqrt(k - b * b);
  Motion motion{Array(1, 200), Array(1, 200), Array(1, 200)};
  for (Eigen::Index i = 0; i < 200; ++i) {
    const double t = 0.05 * static_cast<double>(i);
    const double u = std::exp(-b * t) * std::cos(w * t);
    const double v = -std::exp(-b * t) * (b * std::cos(w * t) + w * std::sin(w * t));
    motion.displacement(0, i) = u;
    motion.velocity(0, i) = v;
    motion.acceleration(0, i) = -(2 * b * v + k * u);
  }
  const std::vector<std::int32_t> labels{0};
  Array k_and_c(1, 2);
  k_and_c << k, c;
  EXPECT_LT(twin_loss<double>(k_and_c, motion, labels, physics).value, 1e-20);
  k_and_c(0, 0) *= 1.1;
  EXPECT_GT(twin_loss<double>(k_and_c, motion, labels, physics).value, 1e-3);
}

/// Returns free damped oscillations of a mass, with new impacts before they have decayed. While the
/// window repeats itself, its energy is in balance.
Motion repeated_impacts(double k, double damping) {
  constexpr Eigen::Index samples = 400;
  constexpr Eigen::Index between = 50;
  constexpr double step = 0.15;
  const double b = damping / 2;
  const double w = std::sqrt(k - b * b);
  // Each impact adds the same oscillation; the rest of the earlier ones is a geometric sum.
  Motion motion{Array::Zero(1, samples), Array::Zero(1, samples), Array::Zero(1, samples)};
  for (Eigen::Index t = 0; t < samples; ++t) {
    for (Eigen::Index strike = -20; strike * between <= t; ++strike) {
      const double since = step * static_cast<double>(t - strike * between);
      const double decay = std::exp(-b * since);
      motion.displacement(0, t) += decay * std::sin(w * since) / w;
      motion.velocity(0, t) += decay * (std::cos(w * since) - b / w * std::sin(w * since));
    }
  }
  motion.acceleration = -(damping * motion.velocity + k * motion.displacement);
  // The force of an impact is in the acceleration of its own sample.
  for (Eigen::Index t = 0; t < samples; t += between) motion.acceleration(0, t) += 1 / step;
  return motion;
}

/// Returns the damping c~ with the least loss of a motion, by trying values.
double best_damping(const Motion& motion, double k, const Physics& physics, Residual residual) {
  const std::vector<Label> labels{0};
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (double c = 0; c < 20; c += 0.1) {
    Array k_and_c(1, 2);
    k_and_c << k, c;
    const double loss =
        twin_loss<double>(k_and_c, motion, labels, physics, {.residual = residual}).value;
    if (loss < least) {
      least = loss;
      best = c;
    }
  }
  return best;
}

TEST(TwinLoss, FindsTheDampingOfRepeatedImpactsByAbsoluteValuesOnly) {
  Physics physics = example_physics();
  physics.contact_n_per_m15 = 0;
  constexpr double k = 1.5;
  constexpr double c = 5.0;
  const Motion motion = repeated_impacts(k, physics.damping * c);
  EXPECT_NEAR(best_damping(motion, k, physics, Residual::absolute), c, 0.11);
  EXPECT_LT(best_damping(motion, k, physics, Residual::squared), 0.3 * c);
}

TEST(TwinLoss, ContactAddsItsTangentStiffnessForSmallMotion) {
  const Physics physics = example_physics();
  constexpr double k = 1.5;
  const double s_0 = static_equilibrium_m(k * stiffness_scale_n_per_m, standing_at(2e-6), physics);
  const double tangent =
      1.5 * physics.contact_n_per_m15 * std::sqrt(s_0 - 2e-6) / stiffness_scale_n_per_m;
  const Motion motion{Array::Constant(1, 4, 1e-3), Array::Zero(1, 4),
                      Array::Constant(1, 4, -(k + tangent) * 1e-3)};
  Array k_and_c(1, 2);
  k_and_c << k, 5.0;
  const std::vector<std::int32_t> labels{0};
  EXPECT_LT(std::sqrt(twin_loss<double>(k_and_c, motion, labels, physics).value),
            1e-5 * (k + tangent) * 1e-3);
}

/// Checks one batch of three windows of both classes.
void expect_twin_loss_gradients(const Physics& physics,
                                const LossInterpretation& interpretation = {}) {
  const std::vector<std::int32_t> labels{0, 1, 1};
  Motion motion = random_motion(3, 8);
  Array k_and_c(3, 2);
  k_and_c << 0.7, 3.0, 1.4, 5.0, 3.0, 9.0;
  const Loss loss = twin_loss<double>(k_and_c, motion, labels, physics, interpretation);
  const auto value = [&] {
    return twin_loss<double>(k_and_c, motion, labels, physics, interpretation).value;
  };
  expect_gradient(loss.by_k_and_c, k_and_c, value, 1e-6);
  expect_gradient(loss.by_displacement, motion.displacement, value, 1e-6);
  expect_gradient(loss.by_velocity, motion.velocity, value);
  expect_gradient(loss.by_acceleration, motion.acceleration, value);
}

TEST(TwinLoss, HasTheGradientsOfFiniteDifferences) {
  expect_twin_loss_gradients(example_physics());
}

TEST(TwinLoss, HasTheGradientsOfFiniteDifferencesForAbsoluteValues) {
  expect_twin_loss_gradients(example_physics(),
                             {.squares = Squares::sum, .residual = Residual::absolute});
}

TEST(TwinLoss, HasTheGradientsOfFiniteDifferencesWhereBallsLiftOff) {
  Physics physics = example_physics();
  physics.acceleration_m_s2 = {300.0, 500.0};
  expect_twin_loss_gradients(physics);
}

TEST(TwinLoss, HasTheGradientsOfFiniteDifferencesWhereTheDefectIsPassed) {
  Physics physics = example_physics();
  physics.acceleration_m_s2 = {300.0, 500.0};
  physics.contact[0] = {
      .outside_m = 2e-6, .inside_m = 4e-6, .at_rest = 0, .passing = {0, 0, 0.4, 1, 1, 0.1, 0, 0}};
  physics.contact[1] = {.outside_m = 2e-6, .inside_m = 9e-6, .at_rest = 0.3};
  expect_twin_loss_gradients(physics);
}

/// At rest without a ball in the defect: the passage of a ball removes the contact's force.
TEST(TwinLoss, PassageIsAForceOnTheRing) {
  Physics physics = example_physics();
  physics.contact[0] = {.outside_m = 2e-6, .inside_m = 1, .at_rest = 0, .passing = {0, 0.25, 1, 0}};
  constexpr double k = 1.5;
  const double s_0 = static_equilibrium_m(k * stiffness_scale_n_per_m, physics.contact[0], physics);
  const double force = physics.load_n - k * stiffness_scale_n_per_m * s_0;  // force of the contact
  ASSERT_GT(force, 0);
  Array k_and_c(1, 2);
  k_and_c << k, 5.0;
  const Motion motion{Array::Zero(1, 4), Array::Zero(1, 4), Array::Zero(1, 4)};
  const double of_full = force / (physics.mass_kg * physics.acceleration_m_s2[0]);
  EXPECT_NEAR(twin_loss<double>(k_and_c, motion, std::vector<std::int32_t>{0}, physics).value,
              of_full * of_full * (1 + 0.25 * 0.25) / 4, 1e-9 * of_full * of_full);
}

TEST(TwinLoss, GradientStaysFiniteWhereContactIsLost) {
  Physics physics = example_physics();
  physics.contact = {standing_at(1.0), standing_at(1.0)};  // deeper than the load can reach
  const Array one = Array::Ones(1, 4);
  Array k_and_c(1, 2);
  k_and_c << 1, 5;
  const std::vector<std::int32_t> labels{0};
  EXPECT_TRUE(
      twin_loss<double>(k_and_c, {one, one, one}, labels, physics).by_k_and_c.isFinite().all());
}

/// A softplus may be exactly 0 in single precision.
TEST(TwinLoss, StaysFiniteWithItsGradientWithoutStiffness) {
  const RowArray<float> one = RowArray<float>::Ones(1, 4);
  const RowArray<float> nothing = RowArray<float>::Zero(1, 2);
  const std::vector<std::int32_t> labels{0};
  const auto loss = twin_loss<float>(nothing, {one, one, one}, labels, example_physics());
  EXPECT_TRUE(std::isfinite(loss.value));
  EXPECT_TRUE(loss.by_k_and_c.isFinite().all());
}

constexpr PerLoss<double> losses_of_a_batch{0.3, 0.05, 2.0};

TEST(TotalLoss, IsWeightedLossesMinusLogarithmsOfWeights) {
  const PerLoss<double> log_weights{std::log(2.0), std::log(0.5), std::log(0.25)};
  const double weighted = 2 * 0.3 + 0.5 * 0.05 + 0.25 * 2;
  EXPECT_NEAR(total_loss(losses_of_a_batch, log_weights, false), weighted, 1e-12);
  // ln 2 + ln 1/2 + ln 1/4 = -2 ln 2.
  EXPECT_NEAR(total_loss(losses_of_a_batch, log_weights), weighted + std::log(2.0), 1e-12);
}

TEST(TotalLoss, DerivativesMatchTheClosedForm) {
  // By ln alpha: alpha L - 1/2.
  const PerLoss<float> at_one = total_loss_by_log_weights(losses_of_a_batch, {0, 0, 0});
  EXPECT_FLOAT_EQ(at_one[0], -0.2F);
  EXPECT_FLOAT_EQ(at_one[1], -0.45F);
  EXPECT_FLOAT_EQ(at_one[2], 1.5F);
  EXPECT_FLOAT_EQ(total_loss_by_log_weights(losses_of_a_batch, {0, 0, 0}, false)[2], 2.0F);
}

TEST(TotalLoss, IsStationaryAtOneOverTwiceEachLoss) {
  const PerLoss<float> log_weights{-std::log(2 * 0.3F), -std::log(2 * 0.05F), -std::log(2 * 2.0F)};
  for (const float slope : total_loss_by_log_weights(losses_of_a_batch, log_weights)) {
    EXPECT_NEAR(slope, 0, 1e-6);
  }
}

}  // namespace
}  // namespace piae::twin
