#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace piae::raw {

/// A whole number of 4 bytes among those of a file.
inline std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at, bool big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + (big_endian ? i : 3 - i)]);
  }
  return number;
}

}  // namespace piae::raw
