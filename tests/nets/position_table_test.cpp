#include "nets/position_table.hpp"

#include <gtest/gtest.h>

#include "nets/layer_gradients.hpp"

namespace piae::nets {
namespace {

TEST(PositionTable, AddsToEachPositionItsOwnNumbers) {
  LayerExample example(
      [](GradientArray<double>& parameters) {
        return std::make_unique<PositionTable<double>>(parameters, "positions");
      },
      position_table_specs("net/positions", three_by_sixteen));
  std::vector<float> values(3 * 16);
  values[16 + 4] = 2;
  example.parameters->write(Parameters<double>::Kept::value, values);
  const std::vector<double> y = example.forward(std::vector<double>(2 * 48, 1), 2);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(y[i], i % 48 == 16 + 4 ? 3 : 1) << i;
  expect_gradients_of_differences(example, 2);
}

}  // namespace
}  // namespace piae::nets
