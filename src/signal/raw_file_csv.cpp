#include <algorithm>
#include <optional>
#include <string_view>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "signal/raw_file.hpp"
#include "signal/raw_limits.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_line(const fs::path& file, std::size_t line, const std::string& what) {
  refuse_raw_file(file.string() + ", line " + std::to_string(line), what);
}

/// A field may be as long as its file.
std::string quoted(std::string_view field) {
  constexpr std::size_t longest = 80;
  if (field.size() <= longest) return "'" + std::string(field) + "'";
  return "'" + std::string(field.substr(0, longest)) + "...'";
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\"");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\"") - first + 1);
}

/// Takes the next line off a text, without its LF or CRLF. What follows the last line end is no
/// line if it is empty.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Takes the next field off a line, which ends with its last.
std::string_view take_field(std::optional<std::string_view>& line, char separator) {
  const std::string_view rest = *line;
  const std::size_t end = rest.find(separator);
  line = end == std::string_view::npos ? std::nullopt : std::optional(rest.substr(end + 1));
  return trimmed(rest.substr(0, end));
}

char separator_of(std::string_view header) {
  for (const char candidate : {';', '\t', ','}) {
    if (header.find(candidate) != std::string_view::npos) return candidate;
  }
  return ',';
}

/// The fields of the first line, of which recordings have a few.
std::vector<std::string_view> fields_of(const fs::path& file, std::string_view line,
                                        char separator) {
  constexpr std::size_t most = 10'000;
  std::vector<std::string_view> fields;
  for (std::optional rest = line; rest;) {
    if (fields.size() == most) {
      refuse_line(file, 1, "has more than " + std::to_string(most) + " columns");
    }
    fields.push_back(take_field(rest, separator));
  }
  return fields;
}

/// One field of a line, which must have so many.
std::string_view field_of(const fs::path& file, std::size_t number, std::string_view line,
                          char separator, std::size_t wanted, std::size_t fields) {
  std::string_view found;
  std::size_t count = 0;
  for (std::optional rest = line; rest; ++count) {
    const std::string_view field = take_field(rest, separator);
    if (count == wanted) found = field;
  }
  if (count != fields) {
    refuse_line(
        file, number,
        "has " + std::to_string(count) + " fields, the first line " + std::to_string(fields));
  }
  return found;
}

/// What names columns has letters. A damaged number has none, or is one of a few that do.
bool is_name(std::string_view field) {
  return std::ranges::any_of(field, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 127;
  });
}

/// The index of a column that is given by its number or by its name.
std::size_t find_column(const fs::path& file, const std::vector<std::string_view>& header,
                        const std::string& column) {
  if (column.find_first_not_of("0123456789") == std::string::npos) {
    const std::size_t number = number_in<std::size_t>(column).value_or(0);
    if (number >= 1 && number <= header.size()) return number - 1;
    refuse_line(file, 1,
                "has no column " + column + "; columns are 1 to " + std::to_string(header.size()));
  }
  const auto found = std::ranges::count(header, column);
  if (found == 1)
    return static_cast<std::size_t>(std::ranges::find(header, column) - header.begin());
  if (found > 1) refuse_line(file, 1, "has several columns " + column);
  refuse_line(file, 1,
              "has no column " + column + "; it has " + listed({header.begin(), header.end()}));
}

}  // namespace

std::vector<double> read_csv(const fs::path& file, const std::string& column) {
  const std::vector<std::byte> bytes = artefact::read_file(file, largest_raw_bytes);
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  std::string_view from_first = text;
  const std::string_view first = take_line(from_first);
  const char separator = separator_of(first);
  const auto header = fields_of(file, first, separator);
  const std::size_t wanted = find_column(file, header, column);
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::string_view field =
        field_of(file, line, take_line(text), separator, wanted, header.size());
    const auto number = number_in<double>(field);
    if (number) {
      numbers.push_back(*number);
    } else if (line > 1) {
      refuse_line(file, line, "column " + column + " holds " + quoted(field) + ", not a number");
    } else if (!is_name(field)) {
      refuse_line(file, line,
                  "column " + column + " holds " + quoted(field) + ", neither a number nor a name");
    }
  }
  return numbers;
}

}  // namespace piae::signal
