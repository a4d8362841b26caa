#include <spdlog/fmt/fmt.h>

#include <optional>
#include <string_view>

#include "raw/csv_doubts.hpp"
#include "raw/csv_fields.hpp"
#include "raw/csv_layout.hpp"
#include "raw/file.hpp"
#include "raw/text.hpp"
#include "raw/times.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

/// True if a line is blank, a comment or text without numbers, as above a second table.
bool holds_no_number(std::string_view line, char separator) {
  if (trimmed(line, blanks).empty() || is_csv_comment(line)) return true;
  for (std::optional rest = line; rest;) {
    if (number_in_field(take_field(rest, separator))) return false;
  }
  return holds_letters(line);
}

/// Refuses a line without numbers among the samples, because a second table may start there.
void require_same_table(const fs::path& file, std::size_t number, std::string_view line,
                        const CsvLayout& layout) {
  if (number == layout.first_line || !holds_no_number(line, layout.separator)) return;
  const std::string_view text = trimmed(line, blanks);
  refuse_csv_line(
      file, number,
      (text.empty() ? "is blank" : "holds " + csv_field_in_quotes(text)) +
          " between lines of numbers; if another table begins here, save it in a file of its own");
}

/// Returns the needed fields of a line. Each line must have the same number of fields, and may end
/// with a separator.
CsvRow fields_of_line(const fs::path& file, std::size_t number, std::string_view line,
                      const CsvLayout& layout) {
  CsvRow found;
  std::string_view last;
  std::size_t count = 0;
  for (std::optional rest = line; rest; ++count) {
    const std::string_view field = take_field(rest, layout.separator);
    if (count == 0) found.first = field;
    if (count == layout.column) found.requested_field = field;
    if (count + 1 == layout.column) found.previous = field;
    if (count == layout.column + 1) found.next = field;
    if (count + 1 == layout.times.column) found.time = field;
    last = field;
  }
  const bool ends_with_separator = count == layout.fields + 1 && last.empty();
  if (count != layout.fields && !ends_with_separator) {
    require_same_table(file, number, line, layout);
    refuse_csv_line(file, number,
                    fmt::format("has {} field{}, the lines above have {}; remove the line, or get "
                                "the file again",
                                count, count == 1 ? "" : "s", layout.fields));
  }
  return found;
}

/// Largest number of fields of one moment: a recording has fewer channels.
constexpr std::size_t largest_row = 100;

}  // namespace

Signal read_table(const fs::path& file, const std::string& column) {
  const std::string text = read_text(file);
  const std::string plain = with_blanks_for_control(text);
  const CsvLayout layout = csv_layout(file, plain.empty() ? text : plain, column);
  if (!plain.empty()) {
    require_no_control_characters(file, text, text.size() - layout.numbers.size());
  }
  std::string_view rest = layout.numbers;
  std::vector<double> numbers;
  std::vector<double> times;
  DecimalSign sign;
  CsvDoubts doubts(file, layout, column);
  for (std::size_t line = layout.first_line; !rest.empty(); ++line) {
    const std::string_view all = take_line(rest);
    const CsvRow fields = fields_of_line(file, line, all, layout);
    const std::string_view field = fields.requested_field;
    const auto number = number_in_field(field);
    const auto refuse = [&](std::string_view why) {
      refuse_csv_line(file, line,
                      fmt::format("column {} holds {}{}", column, csv_field_in_quotes(field), why));
    };
    if (!number) {
      // A single word in a single column may be a garbled number, unless it is the column's name.
      if (layout.fields > 1 || field == column) require_same_table(file, line, all, layout);
      if (is_date_or_time(field) && field.find_first_of(":/-", 1) != field.npos) {
        refuse(", a date or time, not a number; name a column of numbers");
      }
      if (const std::string_view remedy = remedy_for_thousands(field); !remedy.empty()) {
        refuse(", not a number" + std::string(remedy));
      }
      if (line > layout.first_line)
        refuse(", not a number; remove the line, or get the file again");
      refuse(is_column_number(column)
                 ? ", not a number; name a column of numbers"
                 : ", not a number; if this line belongs to the header, name the column by its "
                   "number");
    }
    if (!sign.fits(field)) {
      refuse(
          ", but a line above has the other decimal sign; write decimal points and no thousands "
          "separators");
    }
    doubts.look_at(line, fields, all);
    numbers.push_back(*number);
    const auto time = number_in_field(fields.time);
    if (time) times.push_back(*time);
  }
  if (!numbers.empty()) doubts.require_none();
  if (numbers.size() == 1 && layout.fields > largest_row) {
    refuse_csv_line(file, layout.first_line,
                    "is the only line and has " + std::to_string(layout.fields) +
                        " fields, but a row is one moment; write one number per line");
  }
  Signal signal{.samples = std::move(numbers), .columns = layout.fields};
  signal.may_be_cut = doubts.may_be_cut();
  if (times.size() == signal.samples.size()) signal.times = times_in(times, layout.times);
  return signal;
}

std::vector<double> read_csv(const fs::path& file, const std::string& column) {
  return read_table(file, column).samples;
}

}  // namespace piae::raw
