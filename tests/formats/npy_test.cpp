#include "formats/npy.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "formats/exported_windows.hpp"

namespace piae::formats {
namespace {

TEST(Npy, IsAHeaderAndTheSamples) {
  const std::string file = npy(four_windows());
  const std::string words = "{'descr': '<f4', 'fortran_order': False, 'shape': (4, 2), }";
  const std::string begin("\x93NUMPY\x01\x00", 8);
  ASSERT_EQ(file.size(), 128 + 8 * sizeof(float));  // samples start at a multiple of 64
  EXPECT_EQ(file.substr(0, 8), begin);
  EXPECT_EQ(static_cast<int>(file[8]) + 256 * static_cast<int>(file[9]), 128 - 10);
  EXPECT_EQ(file.substr(10, words.size()), words);
  EXPECT_EQ(file.substr(10 + words.size(), 117 - words.size()),
            std::string(117 - words.size(), ' '));
  EXPECT_EQ(file[127], '\n');
  std::vector<float> samples(8);
  std::memcpy(samples.data(), file.data() + 128, 8 * sizeof(float));
  EXPECT_EQ(samples, four_windows().samples);
}

}  // namespace
}  // namespace piae::formats
