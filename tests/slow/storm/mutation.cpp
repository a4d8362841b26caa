#include "storm/mutation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace piae::storm {

namespace {

/// Limits of number types and of their sums.
constexpr std::array<std::uint64_t, 22> edges{0,
                                              1,
                                              2,
                                              0x7F,
                                              0x80,
                                              0xFF,
                                              0x100,
                                              0x7FFF,
                                              0x8000,
                                              0xFFFF,
                                              0x10000,
                                              0x7FFFFFFF,
                                              0x80000000,
                                              0xFFFFFFFF,
                                              0x100000000,
                                              std::uint64_t{1} << 40U,
                                              std::uint64_t{1} << 61U,
                                              0x7FF0000000000000,
                                              0x7FF8000000000000,
                                              0x7FFFFFFFFFFFFFFF,
                                              0x8000000000000000,
                                              0xFFFFFFFFFFFFFFFF};

/// Parts of text, and parts that text should not have.
constexpr std::array<std::string_view, 26> words{"-1",
                                                 "0",
                                                 "nan",
                                                 "inf",
                                                 "1e300",
                                                 "1e-320",
                                                 "9223372036854775807",
                                                 "99999999999999999999",
                                                 "[",
                                                 "]",
                                                 "[[",
                                                 "{",
                                                 "}",
                                                 "\"",
                                                 "\"\"\"",
                                                 "'",
                                                 "\\",
                                                 "\\u0",
                                                 "\r\n",
                                                 "\n",
                                                 "\t",
                                                 ",",
                                                 ";",
                                                 "=",
                                                 "../",
                                                 "\xFF"};

void write_number(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t width,
                  bool big_endian) {
  for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i) {
    const std::size_t shift = 8 * (big_endian ? width - 1 - i : i);
    bytes[at + i] = static_cast<char>(number >> shift);
  }
}

void write_edge(std::string& bytes, std::size_t at, Dice& dice) {
  static constexpr std::array<std::size_t, 4> widths{1, 2, 4, 8};
  const std::uint64_t number = dice.one_of(edges);
  write_number(bytes, at, number, dice.one_of(widths), dice.one_in(4));
}

/// Returns the length of a piece: mostly short, because fields of a header are close to each other.
std::size_t length_of_piece(std::size_t size, Dice& dice) {
  const std::size_t longest = dice.one_in(4) ? size : std::min<std::size_t>(size, 64);
  return 1 + dice.below(longest);
}

void change(std::string& bytes, const std::string& other, Dice& dice) {
  if (bytes.empty()) {
    bytes = other.substr(0, 1 + dice.below(64));
    return;
  }
  // Changes in headers do most harm, so at least half of them are in the first 512 bytes.
  const std::size_t range =
      dice.one_in(2) ? bytes.size() : std::min<std::size_t>(bytes.size(), 512);
  const std::size_t at = dice.below(range);
  const std::size_t length = length_of_piece(bytes.size() - at, dice);
  switch (dice.below(10)) {
    case 0:
    case 1:
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1U << dice.below(8)));
      break;
    case 2:
    case 3:
      write_edge(bytes, at, dice);
      break;
    case 4:
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length,
                  static_cast<char>(dice.one_in(2) ? 0 : dice.next()));
      break;
    case 5:
      bytes.erase(at, length);
      break;
    case 6:
      bytes.insert(at, bytes.substr(dice.below(bytes.size()), length));
      break;
    case 7:
      bytes.insert(at, dice.one_of(words));
      break;
    case 8: {
      const std::string piece = other.substr(dice.below(other.size() + 1), length);
      bytes.replace(at, std::min(piece.size(), bytes.size() - at), piece);
      break;
    }
    default:
      if (dice.one_in(3))
        bytes.resize(at);
      else
        bytes[at] = static_cast<char>(dice.next());
  }
}

// ---- HDF5's checksum: Bob Jenkins's lookup3, "hashlittle" with an initial value of 0 ----

std::uint32_t rotated(std::uint32_t x, unsigned bits) { return (x << bits) | (x >> (32U - bits)); }

std::uint32_t word_at(const char* bytes, std::size_t length) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(length, 4); ++i) {
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return word;
}

std::uint32_t lookup3(const char* bytes, std::size_t length) {
  std::uint32_t a = 0xDEADBEEF + static_cast<std::uint32_t>(length);
  std::uint32_t b = a;
  std::uint32_t c = a;
  for (; length > 12; bytes += 12, length -= 12) {
    a += word_at(bytes, 4);
    b += word_at(bytes + 4, 4);
    c += word_at(bytes + 8, 4);
    a = (a - c) ^ rotated(c, 4), c += b;
    b = (b - a) ^ rotated(a, 6), a += c;
    c = (c - b) ^ rotated(b, 8), b += a;
    a = (a - c) ^ rotated(c, 16), c += b;
    b = (b - a) ^ rotated(a, 19), a += c;
    c = (c - b) ^ rotated(b, 4), b += a;
  }
  if (length == 0) return c;
  a += word_at(bytes, length);
  if (length > 4) b += word_at(bytes + 4, length - 4);
  if (length > 8) c += word_at(bytes + 8, length - 8);
  c = (c ^ b) - rotated(b, 14);
  a = (a ^ c) - rotated(c, 11);
  b = (b ^ a) - rotated(a, 25);
  c = (c ^ b) - rotated(b, 16);
  a = (a ^ c) - rotated(c, 4);
  b = (b ^ a) - rotated(a, 14);
  return (c ^ b) - rotated(b, 24);
}

/// Returns the block that starts here: it ends where the checksum matches.
std::optional<Block> block_at(const std::string& bytes, std::size_t at) {
  constexpr std::size_t longest = 4096;
  for (std::size_t size = 8; size <= longest && at + size + 4 <= bytes.size(); ++size) {
    if (lookup3(&bytes[at], size) == word_at(&bytes[at + size], 4)) return Block{at, size};
  }
  return {};
}

}  // namespace

std::string mutated(const std::string& good, const std::string& other, Dice& dice) {
  std::string bytes = good;
  const std::size_t changes = 1 + dice.below(4);
  for (std::size_t i = 0; i < changes; ++i) change(bytes, other, dice);
  return bytes;
}

std::vector<Block> checksummed_blocks(const std::string& good) {
  static constexpr std::array<std::string_view, 12> signatures{"\x89HDF", "OHDR", "OCHK", "FRHP",
                                                               "FHDB",    "FHIB", "BTHD", "BTLF",
                                                               "BTIN",    "FAHD", "FADB", "FSHD"};
  std::vector<Block> blocks;
  for (std::size_t at = 0; at + 4 <= good.size(); ++at) {
    if (std::ranges::find(signatures, std::string_view(good).substr(at, 4)) == signatures.end()) {
      continue;
    }
    if (const auto block = block_at(good, at)) blocks.push_back(*block);
  }
  return blocks;
}

void renew_checksums(std::string& bytes, const std::vector<Block>& blocks) {
  for (const Block& block : blocks) {
    if (block.at + block.size + 4 > bytes.size()) continue;
    write_number(bytes, block.at + block.size, lookup3(&bytes[block.at], block.size), 4, false);
  }
}

std::string mutated_with_checksums(const std::string& good, const std::vector<Block>& blocks,
                                   Dice& dice) {
  std::string bytes = good;
  if (blocks.empty()) return bytes;
  const std::size_t changes = 1 + dice.below(3);
  for (std::size_t i = 0; i < changes; ++i) {
    const Block& block = dice.one_of(blocks);
    const std::size_t at = block.at + 4 + dice.below(block.size - 4);
    if (dice.one_in(2)) {
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1U << dice.below(8)));
    } else if (dice.one_in(2)) {
      write_edge(bytes, at, dice);
    } else {
      bytes[at] = static_cast<char>(dice.next());
    }
  }
  renew_checksums(bytes, blocks);
  return bytes;
}

}  // namespace piae::storm
