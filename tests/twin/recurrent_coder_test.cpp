#include "twin/recurrent_coder.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace piae::twin {
namespace {

TwinOptions with_depth(int depth) {
  TwinOptions options;
  options.depth = depth;
  return options;
}

TEST(RecurrentCoder, NamesPossibleWindowsAndDepths) {
  EXPECT_ERROR(RecurrentCoder({1000, 2}, with_depth(3)), Exit::usage,
               "windows of 1000 samples do not divide into frames of 32 samples, which are read in "
               "turn; use multiples of 32 samples (split --window)");
  EXPECT_ERROR(
      RecurrentCoder({1024, 2}, with_depth(1)), Exit::usage,
      "--depth: 1 leaves no recurrent layer, because the layer at (k, c) is dense; use 2 or "
      "more");
}

// Stored models with these names and shapes must stay readable.
TEST(RecurrentCoder, HasGatedLayersAndADenseLayer) {
  const RecurrentCoder coder({1024, 10}, with_depth(3));
  EXPECT_EQ(coder.frames(), 32);
  std::vector<std::string> lines;
  for (const nets::ParameterSpec& spec : coder.specs()) {
    std::string line = spec.name;
    for (const std::int64_t n : spec.shape) line += " " + std::to_string(n);
    lines.push_back(line);
  }
  const std::vector<std::string> expected{
      "net/encoder/gru0/input_weight 288 32", "net/encoder/gru0/state_weight 288 96",
      "net/encoder/gru0/input_bias 288",      "net/encoder/gru0/state_bias 288",
      "net/encoder/gru1/input_weight 288 96", "net/encoder/gru1/state_weight 288 96",
      "net/encoder/gru1/input_bias 288",      "net/encoder/gru1/state_bias 288",
      "net/encoder/dense/weight 2 96",        "net/encoder/dense/bias 2",
      "net/decoder/gru0/input_weight 288 12", "net/decoder/gru0/state_weight 288 96",
      "net/decoder/gru0/input_bias 288",      "net/decoder/gru0/state_bias 288",
      "net/decoder/gru1/input_weight 288 96", "net/decoder/gru1/state_weight 288 96",
      "net/decoder/gru1/input_bias 288",      "net/decoder/gru1/state_bias 288",
      "net/decoder/dense/weight 32 96",       "net/decoder/dense/bias 32"};
  EXPECT_EQ(lines, expected);
}

}  // namespace
}  // namespace piae::twin
