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

/// The lines of a text without LF or CRLF and without a byte order mark. What follows the last line
/// end is no line if it is empty.
std::vector<std::string_view> lines_of(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

char separator_of(std::string_view header) {
  for (const char candidate : {';', '\t', ','}) {
    if (header.find(candidate) != std::string_view::npos) return candidate;
  }
  return ',';
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
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
  const auto lines = lines_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  std::vector<double> numbers;
  if (lines.empty()) return numbers;
  const char separator = separator_of(lines.front());
  const auto header = fields_of(lines.front(), separator);
  const std::size_t wanted = find_column(file, header, column);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto fields = fields_of(lines[i], separator);
    if (fields.size() != header.size()) {
      refuse_line(file, i + 1,
                  "has " + std::to_string(fields.size()) + " fields, the first line " +
                      std::to_string(header.size()));
    }
    const auto number = number_in<double>(fields[wanted]);
    if (number) {
      numbers.push_back(*number);
    } else if (i > 0) {
      refuse_line(file, i + 1,
                  "column " + column + " holds " + quoted(fields[wanted]) + ", not a number");
    }
  }
  return numbers;
}

}  // namespace piae::signal
