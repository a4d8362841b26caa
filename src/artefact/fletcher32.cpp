#include "artefact/fletcher32.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace piae::artefact {

namespace {

constexpr std::uint64_t modulus = 65535;

/// For this many words, the sum of each word times its place from the end fits into 32 bits.
constexpr std::size_t words_at_once = 256;

/// HDF5 reduces the sum to 1..65535 and gives 0 only if all words are zero.
std::uint32_t folded(std::uint64_t sum) {
  return sum == 0 ? 0 : static_cast<std::uint32_t>((sum - 1) % modulus + 1);
}

}  // namespace

std::uint32_t fletcher32(std::span<const std::byte> bytes) {
  if (bytes.size() % 2 != 0) throw std::logic_error("a fletcher32 checksum of half a word");
  std::uint64_t sum = 0;
  std::uint64_t sum_of_sums = 0;
  while (!bytes.empty()) {
    std::uint16_t words[words_at_once] = {};
    const std::size_t count = std::min(bytes.size() / 2, words_at_once);
    std::memcpy(words, bytes.data(), 2 * count);
    std::uint32_t block = 0;
    std::uint32_t weighted = 0;
    for (std::uint32_t i = 0; i < words_at_once; ++i) {
      block += words[i];
      weighted += words[i] * (static_cast<std::uint32_t>(words_at_once) - i);
    }
    // The zero padding of the last block has counted each word too often.
    const std::uint64_t exact = weighted - std::uint64_t{words_at_once - count} * block;
    sum_of_sums = folded(sum_of_sums + count * sum + exact);
    sum = folded(sum + block);
    bytes = bytes.subspan(2 * count);
  }
  // Words are read byte-swapped above, which multiplies the sums by 256 modulo 65535.
  return folded(256 * sum_of_sums) << 16U | folded(256 * sum);
}

}  // namespace piae::artefact
