#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace piae::raw {

inline constexpr const char* blanks = " \t";

/// Returns a text without leading and trailing characters of `what`.
inline std::string_view trimmed(std::string_view text, const char* what) {
  const std::size_t first = text.find_first_not_of(what);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(what) - first + 1);
}

/// True if the text is one digit or more, and nothing else.
inline bool is_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// True if the text has letters, as column names do. Few damaged numbers have any.
inline bool holds_letters(std::string_view text) {
  return std::ranges::any_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 127;
  });
}

/// True if a line starts with # or %.
inline bool is_csv_comment(std::string_view line) {
  const std::string_view text = trimmed(line, blanks);
  return text.starts_with('#') || text.starts_with('%');
}

/// Takes the next line off a text, without its LF, CRLF or CRCRLF. Empty text after the last line
/// end does not count as a line.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  while (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Returns the end of a field: the next separator outside quotes. A quote opens a field only at its
/// start.
inline std::size_t end_of_field(std::string_view line, char separator) {
  const std::size_t first = line.find_first_not_of(blanks);
  const bool is_quoted = first != std::string_view::npos && line[first] == '"';
  const std::size_t closing = is_quoted ? line.find('"', first + 1) : std::string_view::npos;
  return line.find(separator, closing == std::string_view::npos ? 0 : closing);
}

/// Takes the next field off a line, without the blanks and quotes around it. `line` is empty after
/// its last field. A separator ' ' means any number of blanks and tabs, also at the ends of the
/// line.
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

/// Returns a number with a decimal point or a decimal comma, which only a field in quotes has if
/// commas separate the fields. A plus may precede it. Returns nothing for any other text.
std::optional<double> number_in_field(std::string_view field);

/// True if a column is named by its number.
inline bool is_column_number(std::string_view column) {
  return column.find_first_not_of("0123456789") == std::string_view::npos;
}

/// True for "24.02.2024 10:00:00", "2024-02-24", "10:00:00,5", "2024-02-24T10:00:00Z".
bool is_date_or_time(std::string_view text);

/// Returns what to do about a number with separators of thousands, such as 1.640,337; empty for
/// other texts.
inline std::string_view remedy_for_thousands(std::string_view field) {
  const bool may_have_thousands = field.find('.') != std::string_view::npos &&
                                  field.find(',') != std::string_view::npos &&
                                  field.find_first_not_of("+-0123456789.,eE") == field.npos;
  return may_have_thousands ? "; write decimal points and no thousands separators" : "";
}

/// Remembers the decimal sign of a column. If a column has both a point and a comma, one of them
/// separates thousands.
class DecimalSign {
 public:
  DecimalSign() = default;
  /// Starts with the declared sign, "." or ","; with no sign for other texts.
  explicit DecimalSign(std::string_view stated) : comma_(stated == ","), point_(stated == ".") {}

  /// True if the field has the same decimal sign as the fields before.
  bool fits(std::string_view field) {
    comma_ = comma_ || field.find(',') != std::string_view::npos;
    point_ = point_ || field.find('.') != std::string_view::npos;
    return !(comma_ && point_);
  }

 private:
  bool comma_ = false;
  bool point_ = false;
};

/// Compares the decimals of a column's numbers. Programs that print a fixed number of decimals
/// print it for all numbers; programs that drop zeros at the end show it in every tenth number.
class Decimals {
 public:
  struct Number {
    std::size_t line = 0;
    std::string_view text;
  };

  void add(std::size_t line, std::string_view number);
  /// Returns the first whole number if such numbers are rare and all others have the same two or
  /// more decimals, some with a 0 at the end, which shows that zeros are not dropped. Ignores 0,
  /// which MATLAB prints without decimals.
  [[nodiscard]] std::optional<Number> whole_number() const;
  /// Returns the last number if it alone has fewer decimals, or digits of the exponent, than all
  /// others.
  [[nodiscard]] std::optional<Number> short_end() const;
  /// True if the last number is shorter than 95 % of the others. Numbers whose length varies do not
  /// show more.
  [[nodiscard]] bool has_rare_end() const;

 private:
  static constexpr std::size_t enough = 100;  ///< numbers alike for each other number

  std::size_t length_ = 0;  ///< usual number of characters after the decimal sign
  std::size_t alike_ = 0;
  std::size_t others_ = 0;     ///< numbers with another length
  bool has_zero_end_ = false;  ///< true if the decimals of a number end with 0
  std::size_t wholes_ = 0;     ///< numbers without a decimal sign, but 0
  std::size_t zeros_ = 0;
  Number first_whole_;
  Number last_;
  std::size_t last_length_ = 0;
  std::array<std::size_t, 32> by_size_{};  ///< counts of numbers by their size in characters
};

/// Returns the separator of a line's fields: a semicolon, a tab, a bar, a comma or blanks.
char separator_of(std::string_view line);

}  // namespace piae::raw
