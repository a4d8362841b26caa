#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace piae::raw {

inline constexpr const char* blanks = " \t";

/// A text without what stands at its ends of these characters.
inline std::string_view trimmed(std::string_view text, const char* what) {
  const std::size_t first = text.find_first_not_of(what);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(what) - first + 1);
}

/// Tells text, such as names of columns, by its letters. A damaged number has none, or is one of a
/// few that do.
inline bool holds_letters(std::string_view text) {
  return std::ranges::any_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 127;
  });
}

/// True of a line that begins with # or %.
inline bool is_csv_comment(std::string_view line) {
  const std::string_view text = trimmed(line, blanks);
  return text.starts_with('#') || text.starts_with('%');
}

/// Takes the next line off a text, without its LF, CRLF or CRCRLF. What follows the last line end
/// is no line if it is empty.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  while (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// The end of a field: the next separator that stands in no quotes. A quote opens a field only at
/// its beginning.
inline std::size_t end_of_field(std::string_view line, char separator) {
  const std::size_t first = line.find_first_not_of(blanks);
  const bool is_quoted = first != std::string_view::npos && line[first] == '"';
  const std::size_t closing = is_quoted ? line.find('"', first + 1) : std::string_view::npos;
  return line.find(separator, closing == std::string_view::npos ? 0 : closing);
}

/// Takes the next field off a line, without the blanks and quotes around it; the line is empty once
/// its last has been taken. A separator ' ' stands for any number of blanks and tabs, which may
/// stand at the ends of the line, too.
inline std::string_view take_field(std::optional<std::string_view>& line, char separator) {
  constexpr const char* around = " \t\"";
  if (separator == ' ') {
    const std::string_view rest = trimmed(*line, blanks);
    const std::size_t end = rest.find_first_of(blanks);
    line = end == std::string_view::npos ? std::nullopt : std::optional(rest.substr(end + 1));
    return trimmed(rest.substr(0, end), around);
  }
  const std::string_view rest = *line;
  const std::size_t end = end_of_field(rest, separator);
  line = end == std::string_view::npos ? std::nullopt : std::optional(rest.substr(end + 1));
  return trimmed(rest.substr(0, end), around);
}

/// A number with a decimal point or, where commas do not separate the fields, a decimal comma; a
/// plus may stand before it. None for any other text.
std::optional<double> number_in_field(std::string_view field, char separator);

/// Remembers which sign a column has before its decimals. Both in one column are a sign of
/// thousands.
class DecimalSign {
 public:
  DecimalSign() = default;
  /// Starts with the sign that the file declares, "." or ","; with none otherwise.
  explicit DecimalSign(std::string_view said) : comma_(said == ","), point_(said == ".") {}

  /// True if the field goes together with those before.
  bool fits(std::string_view field) {
    comma_ = comma_ || field.find(',') != std::string_view::npos;
    point_ = point_ || field.find('.') != std::string_view::npos;
    return !(comma_ && point_);
  }

 private:
  bool comma_ = false;
  bool point_ = false;
};

/// Finds the separator of a line's fields: a semicolon, a tab, a bar, a comma or blanks.
char separator_of(std::string_view line);

}  // namespace piae::raw
