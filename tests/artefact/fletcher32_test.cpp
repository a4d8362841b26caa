#include "artefact/fletcher32.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"

namespace piae::artefact {
namespace {

/// Adds up the words as HDF5 does (H5_checksum_fletcher32).
std::uint32_t word_by_word(const std::vector<std::byte>& bytes) {
  std::uint32_t sum = 0;
  std::uint32_t sum_of_sums = 0;
  const auto fold = [](std::uint32_t& x) { x = (x & 0xffffU) + (x >> 16U); };
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    sum += std::to_integer<std::uint32_t>(bytes[i]) << 8U |
           std::to_integer<std::uint32_t>(bytes[i + 1]);
    fold(sum);
    sum_of_sums += sum;
    fold(sum_of_sums);
  }
  return sum_of_sums << 16U | sum;
}

TEST(Fletcher32, MatchesAdditionWordByWord) {
  Stream stream("fletcher32");
  for (const std::size_t size : {2U, 4U, 510U, 512U, 514U, 1024U, 4098U, 100'000U}) {
    std::vector<std::byte> bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(stream.uniform(0, 256));
    EXPECT_EQ(fletcher32(bytes), word_by_word(bytes)) << size;
  }
}

TEST(Fletcher32, GivesFixedSumsForZerosAndOnes) {
  EXPECT_EQ(fletcher32(std::vector<std::byte>(600)), 0U);
  EXPECT_EQ(fletcher32(std::vector<std::byte>(600, std::byte{0xff})), 0xffffffffU);
  EXPECT_EQ(fletcher32({}), 0U);
}

}  // namespace
}  // namespace piae::artefact
