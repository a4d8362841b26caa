#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace piae::formats {

/// Builds the bytes of a file from its beginning; numbers are little-endian.
class Bytes {
 public:
  void text(std::string_view text) { bytes_ += text; }
  void number(std::unsigned_integral auto value) {
    for (std::size_t i = 0; i < sizeof(value); ++i) {
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
    }
  }
  void number(float value) { number(std::bit_cast<std::uint32_t>(value)); }
  void number(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  /// Adds zeros until the size is a multiple of `unit`.
  void pad(std::size_t unit) { bytes_.resize((bytes_.size() + unit - 1) / unit * unit); }

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }
  [[nodiscard]] const std::string& all() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace piae::formats
