#include "nets/gru_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

constexpr std::int64_t gru_units = 16;

LayerExample::Make gru_of(std::int64_t input_length, std::int64_t length) {
  return [=](GradientArray<double>& parameters) {
    return std::make_unique<GruLayer<double>>(parameters, "gru", input_length, length);
  };
}
LayerExample recurrent(std::int64_t input_length, std::int64_t length,
                       std::int64_t units = gru_units) {
  return LayerExample(gru_of(input_length, length), gru_specs("net/gru", 16, units));
}

/// r = s(x_r + h_r), z = s(x_z + h_z), n = tanh(x_n + r h_n), h' = (1 - z) n + z h (Cho et al.
/// 2014), here for unit 1 alone, over two positions.
TEST(GruLayer, ReadsItsPositionsInTurn) {
  LayerExample example = recurrent(2, 2);
  const auto& all = example.parameters->parameters();
  double* const values = example.parameters->data(Parameters<double>::Kept::value);
  std::fill(values, values + all.back().begin + all.back().held_columns, 0.0);
  const auto set = [&](const std::string& name, std::int64_t row, std::int64_t column,
                       double value) {
    const auto& p = example.parameters->find("net/gru/" + name);
    values[p.begin + row * p.held_columns + column] = value;
  };
  set("input_weight", 1, 0, 0.7);                  // r from input 0
  set("input_weight", gru_units + 1, 0, 0.5);      // z
  set("input_weight", 2 * gru_units + 1, 0, 1.0);  // n
  set("state_weight", 1, 1, 0.9);                  // r from the unit's own state
  set("state_weight", gru_units + 1, 1, -0.4);     // z
  set("state_weight", 2 * gru_units + 1, 1, 1.5);  // n
  set("input_bias", 0, 2 * gru_units + 1, 0.1);    // n
  set("state_bias", 0, 2 * gru_units + 1, 0.2);    // n, scaled by r
  std::vector<double> x(2 * 16);
  x[0] = 0.8;
  x[16] = -0.6;
  const std::vector<double> y = example.forward(x, 1);
  double h = 0;
  for (const std::size_t t : {0, 1}) {
    const auto s = [](double v) { return 1 / (1 + std::exp(-v)); };
    const double in = x[t * 16];
    const double r = s(0.7 * in + 0.9 * h);
    const double z = s(0.5 * in - 0.4 * h);
    const double n = std::tanh(in + 0.1 + r * (1.5 * h + 0.2));
    h = (1 - z) * n + z * h;
    EXPECT_NEAR(y[t * 16 + 1], h, 1e-14);
    EXPECT_EQ(y[t * 16], 0);
  }
}

TEST(GruLayer, TreatsOneInputAsTheInputOfEachPosition) {
  const std::vector<double> x = random_numbers("x", 16);
  std::vector<double> repeated;
  for (int t = 0; t < 3; ++t) repeated.insert(repeated.end(), x.begin(), x.end());
  EXPECT_EQ(recurrent(1, 3).forward(x, 1), recurrent(3, 3).forward(repeated, 1));
}

TEST(GruLayer, HasTheGradientsOfFiniteDifferences) {
  for (const std::int64_t input_length : {1, 3}) {
    LayerExample example = recurrent(input_length, 3);
    expect_gradients_of_differences(example, 2);
  }
  LayerExample single = recurrent(1, 1, 32);
  expect_gradients_of_differences(single, 3);
}

TEST(GruLayer, KeepsNoStateBetweenBatches) {
  for (const std::int64_t input_length : {1, 4}) {
    expect_that_batches_leave_nothing_behind(gru_of(input_length, 4),
                                             gru_specs("net/gru", 16, gru_units));
  }
}

TEST(GruLayer, PropagatesNan) {
  LayerExample example = recurrent(2, 2);
  std::vector<double> x = random_numbers("x", std::int64_t{2} * 2 * 16);
  x[2 * 16 + 3] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> y = example.forward(x, 2);
  EXPECT_TRUE(std::isfinite(y[2 * 16 - 1]));
  EXPECT_TRUE(std::isnan(y[4 * 16 - 1]));
}

TEST(GruLayer, RefusesImpossibleUnitsAndLengths) {
  EXPECT_THROW(recurrent(2, 2, 17), std::logic_error);
  EXPECT_THROW(recurrent(2, 3), std::logic_error);
}

}  // namespace
}  // namespace piae::nets
