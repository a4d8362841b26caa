#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

namespace piae {

/// Parses a text that is a single number in the C locale. Returns an empty value for any other
/// text, and for a number that T cannot hold.
template <class T>
std::optional<T> number_in(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

/// Returns the index of the first sample that is NaN, infinite or beyond 32 bits; empty if all
/// samples are valid.
inline std::optional<std::size_t> first_beyond_32_bits(std::span<const double> samples) {
  const auto beyond = std::ranges::find_if_not(
      samples, [](double x) { return std::isfinite(static_cast<float>(x)); });
  if (beyond == samples.end()) return std::nullopt;
  return static_cast<std::size_t>(beyond - samples.begin());
}

}  // namespace piae
