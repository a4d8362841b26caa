#include "twin/convolutional_coder.hpp"

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace piae::twin {
namespace {

ConvolutionalCoder convolutional_coder(std::int64_t samples, int depth) {
  TwinOptions options;
  options.depth = depth;
  return {{.samples = samples, .classes = 10}, options};
}

TEST(ConvolutionalCoder, NamesPossibleWindowsAndDepths) {
  EXPECT_ERROR(convolutional_coder(1000, 4), Exit::usage,
               "windows of 1000 samples do not fit 3 convolutions of stride 4; use multiples of "
               "64 samples (split --window) or a smaller --depth");
  EXPECT_ERROR(convolutional_coder(1024, 32), Exit::usage, "--depth");
  EXPECT_ERROR(convolutional_coder(1024, 1), Exit::usage, "--depth: 1 leaves no convolution");
  EXPECT_EQ(convolutional_coder(1024, 6).inner_length(), 1);
}

// Stored models with these names and shapes must stay readable.
TEST(ConvolutionalCoder, HasConvolutionsAndADenseLayer) {
  std::vector<std::string> lines;
  for (const nets::ParameterSpec& spec : convolutional_coder(1024, 3).specs()) {
    std::string line = spec.name;
    for (const std::int64_t n : spec.shape) line += " " + std::to_string(n);
    lines.push_back(line);
  }
  const std::vector<std::string> expected{
      "net/encoder/conv0/weight 16 1 8",  "net/encoder/conv0/bias 16",
      "net/encoder/conv1/weight 32 16 8", "net/encoder/conv1/bias 32",
      "net/encoder/dense/weight 2 2048",  "net/encoder/dense/bias 2",
      "net/decoder/dense/weight 2048 12", "net/decoder/dense/bias 2048",
      "net/decoder/conv0/weight 32 16 8", "net/decoder/conv0/bias 16",
      "net/decoder/conv1/weight 16 1 8",  "net/decoder/conv1/bias 1"};
  EXPECT_EQ(lines, expected);
}

}  // namespace
}  // namespace piae::twin
