#include "monitor/text_samples.hpp"

#include <spdlog/fmt/fmt.h>

#include <limits>
#include <optional>
#include <string_view>

#include "base/numbers.hpp"
#include "base/one_line.hpp"

namespace piae::monitor {

namespace {

constexpr std::size_t longest_line = 100;

std::string_view without_blanks(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

/// Reads a number that may start with a plus, as instruments write it; number_in does not read a
/// plus.
std::optional<double> number_of(std::string_view text) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return number_in<double>(text.substr(has_plus ? 1 : 0));
}

}  // namespace

void TextSamples::add(std::span<const std::byte> bytes, std::vector<double>& samples) {
  for (const std::byte byte : bytes) {
    const char c = static_cast<char>(byte);
    if (c == '\n') {
      end_line(samples);
    } else if (line_.size() < longest_line) {
      line_ += c;
    } else {
      is_too_long_ = true;
    }
  }
}

void TextSamples::end_line(std::vector<double>& samples) {
  ++ended_;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (ended_ == 1 && line_.starts_with(byte_order_mark)) line_.erase(0, byte_order_mark.size());
  const std::string_view text = without_blanks(line_);
  const std::optional<double> value = is_too_long_ ? std::nullopt : number_of(text);
  if (!value && !text.empty()) {
    ++garbled_;
    if (first_garbled_.empty()) {
      first_garbled_ = fmt::format(
          "{}, line {}: '{}{}' is not a number; a line of --format text must hold one sample",
          name_, ended_, one_line(text), is_too_long_ ? "..." : "");
    }
    samples.push_back(std::numeric_limits<double>::quiet_NaN());
  } else if (value) {
    samples.push_back(*value);
  }
  line_.clear();
  is_too_long_ = false;
}

void TextSamples::finish(std::vector<double>& samples) {
  if (!line_.empty()) end_line(samples);
}

void TextSamples::restart() {
  line_.clear();
  is_too_long_ = false;
}

}  // namespace piae::monitor
