#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace piae {

/// Reads a text that is one number and nothing else, written as in the C locale. Empty for any
/// other text, and for a number that T cannot hold.
template <class T>
std::optional<T> number_in(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  return value;
}

}  // namespace piae
