#include "nets/joined_networks.hpp"

#include <gtest/gtest.h>

#include "nets/convolution_example.hpp"

namespace piae::nets {
namespace {

// Their gradients are tested in convolutional_chain_test.cpp.
TEST(JoinedNetworks, GiveTheSecondWhatTheFirstGaveTransposedAndAboveZero) {
  std::vector<ParameterSpec> specs = dense_specs("first", 1, 6);
  append(specs, dense_specs("second", 6, 6));
  const auto parameters = std::make_shared<Parameters<double>>(specs, Stream("test"));
  std::vector<float> values{1, -2, 3, 4, 5, -6, 0, 0, 0, 0, 0, 0};  // first weight and bias
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) values.push_back(i == j ? 1 : 0);
  }
  values.insert(values.end(), 6, 0.0F);
  parameters->write(Parameters<double>::Kept::value, values);
  JoinedNetworks<double> joined(std::make_unique<DenseChain<double>>(parameters, "first", 1), 2, 3,
                                std::make_unique<DenseChain<double>>(parameters, "second", 1));
  joined.input().row(0)[0] = 1;
  RowArray<double> expected(1, 6);
  expected << 1, 4, 0, 5, 3, 0;  // of [1 -2 3; 4 5 -6]
  EXPECT_TRUE((copied(joined.forward(1), 1, 6) == expected).all());
}

}  // namespace
}  // namespace piae::nets
