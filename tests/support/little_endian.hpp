#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace piae {

/// Returns a number in so many bytes, low byte first.
inline std::string little(std::uint64_t number, std::size_t bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xFFU);
  return text;
}

}  // namespace piae
