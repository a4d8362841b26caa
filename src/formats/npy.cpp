#include "formats/npy.hpp"

#include <spdlog/fmt/fmt.h>

#include "formats/bytes.hpp"

namespace piae::formats {

namespace {

constexpr std::string_view magic = "\x93NUMPY\x01";
/// Alignment of the samples.
constexpr std::size_t alignment = 64;

}  // namespace

std::string npy(const signal::WindowSet& windows) {
  const std::size_t before_words = magic.size() + 1 + sizeof(std::uint16_t);
  std::string words = fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}), }}",
                                  windows.size(), windows.length);
  while ((before_words + words.size() + 1) % alignment != 0) words += ' ';
  words += '\n';
  Bytes bytes;
  bytes.text(magic);
  bytes.number(std::uint8_t{0});  // version 1.0
  bytes.number(static_cast<std::uint16_t>(words.size()));
  bytes.text(words);
  for (const float x : windows.samples) bytes.number(x);
  return bytes.take();
}

}  // namespace piae::formats
