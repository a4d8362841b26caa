#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace piae::raw {

/// Reads a number of type T at byte `at`; `bytes` must hold all of it.
template <class T = std::uint32_t>
T number_at(std::span<const std::byte> bytes, std::size_t at, bool big_endian) {
  std::array<std::byte, sizeof(T)> own{};
  std::ranges::copy(bytes.subspan(at, sizeof(T)), own.begin());
  if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(own);
  return std::bit_cast<T>(own);
}

/// Reads a number of type T as a double, for tables of number types.
template <class T>
double double_at(std::span<const std::byte> bytes, std::size_t at, bool big_endian) {
  return static_cast<double>(number_at<T>(bytes, at, big_endian));
}

}  // namespace piae::raw
