#include "raw/csv_layout.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers.hpp"
#include "base/one_line.hpp"
#include "raw/csv_fields.hpp"
#include "raw/file.hpp"
#include "raw/times.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

/// Largest number of lines before the numbers.
constexpr std::size_t most_lines_before = 10'000;
/// Number of successive rows of numbers that show the layout.
constexpr std::size_t most_lines_of_numbers = 200;

/// Stands for the separator of a single column.
constexpr char no_separator = ';';

/// True for words that instruments write instead of a sample, such as OVL.
bool is_missing_sample(std::string_view field) {
  constexpr std::array words{"OVL",  "OVLD", "OVER",   "OVERLOAD", "OVERFLOW", "OVERRANGE",
                             "OVF",  "OVR",  "OFL",    "OL",       "NA",       "N/A",
                             "NULL", "#N/A", "#NAME?", "#NUM!"};
  std::string upper(field);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return std::ranges::count(words, upper) > 0;
}

/// True for "g", "m/s^2", "Sensor 1", "10 mV" and empty text. False for numbers such as NaN, for
/// words such as OVL, and for a damaged number, which has more digits than letters, or a decimal
/// sign.
bool is_word_or_unit(std::string_view field) {
  if (number_in_field(field) || is_missing_sample(field)) return false;
  const auto count = [&](auto is_counted) { return std::ranges::count_if(field, is_counted); };
  const auto digits = count([](char c) { return c >= '0' && c <= '9'; });
  const auto letters = count([](char c) { return holds_letters({&c, 1}); });
  const bool starts_as_number = field.find_first_of("0123456789.,") == 0;
  const bool has_blank = field.find_first_of(blanks) != std::string_view::npos;
  return digits == 0 || (letters >= digits && (!starts_as_number || has_blank));
}

/// Format of a number's text.
struct Form {
  bool has_decimals = false;
  std::size_t decimals = 0;  ///< digits after the decimal sign
  bool has_exponent = false;

  bool operator==(const Form&) const = default;
};

Form form_of(std::string_view number) {
  const std::size_t exponent = std::min(number.find_first_of("eE"), number.size());
  const std::size_t sign = number.substr(0, exponent).find_first_of(".,");
  if (sign == std::string_view::npos) return {.has_exponent = exponent < number.size()};
  return {.has_decimals = true,
          .decimals = exponent - sign - 1,
          .has_exponent = exponent < number.size()};
}

/// Returns the fields of a line. Refuses more than 10,000, because recordings have a few.
std::vector<std::string_view> fields_of(const fs::path& file, std::size_t number,
                                        std::string_view line, char separator) {
  constexpr std::size_t most = 10'000;
  std::vector<std::string_view> fields;
  for (std::optional rest = line; rest;) {
    if (fields.size() == most) {
      refuse_csv_line(file, number,
                      "has more than " + std::to_string(most) +
                          " columns, but a row is one moment; write one number per line");
    }
    fields.push_back(take_field(rest, separator));
  }
  return fields;
}

/// Returns what else may be wrong if a line has more fields than names: commas in its numbers.
std::string_view remedy_for_decimal_commas(std::size_t names, std::size_t fields,
                                           std::string_view line) {
  const bool may_be = names < fields && fields <= 2 * names && separator_of(line) == ',' &&
                      line.find('.') == line.npos;
  return may_be ? ", or separate the fields by semicolons if the numbers have decimal commas" : "";
}

struct Line {
  std::size_t number = 0;
  bool is_comment = false;
  std::string_view text;       ///< without comment marks
  std::string_view from_here;  ///< text from this line to the end
};

/// Counts the numbers of a line that holds nothing else; returns 0 for any other line, also for a
/// comment. A separator may end the line.
std::size_t count_numbers(const Line& line) {
  if (line.is_comment) return 0;
  const char separator = separator_of(line.text);
  std::size_t numbers = 0;
  for (std::optional rest = line.text; rest;) {
    const std::string_view field = take_field(rest, separator);
    if (!rest && field.empty() && numbers > 0) break;
    if (!number_in_field(field)) return 0;
    ++numbers;
  }
  return numbers;
}

/// Returns the first lines that are not blank.
std::vector<Line> lines_at_beginning(std::string_view text) {
  std::vector<Line> lines;
  std::size_t rows = 0;  // successive rows of numbers
  for (std::size_t number = 1;
       number <= most_lines_before && rows <= most_lines_of_numbers && !text.empty(); ++number) {
    Line line{.number = number, .is_comment = false, .text = {}, .from_here = text};
    line.text = take_line(text);
    if (trimmed(line.text, blanks).empty()) continue;
    line.is_comment = is_csv_comment(line.text);
    if (line.is_comment) {
      const std::size_t words = line.text.find_first_not_of("#% \t");
      line.text.remove_prefix(std::min(words, line.text.size()));
    }
    rows = count_numbers(line) > 0 ? rows + 1 : 0;
    lines.push_back(line);
  }
  return lines;
}

class Search {
 public:
  Search(const fs::path& file, std::string_view text, std::string column)
      : file_(file), column_(std::move(column)), lines_(lines_at_beginning(text)) {}

  CsvLayout run() {
    if (lines_.empty()) return {};
    std::optional<CsvLayout> found = is_column_number(column_) ? find_by_number() : find_by_name();
    if (!found) refuse_column();
    found->has_name = is_named_above(*found);
    found->names = count_names_above(*found);
    require_no_other_numbers_above(*found);
    found->times = times_in(*found);
    return *found;
  }

 private:
  [[nodiscard]] std::vector<std::string_view> fields(const Line& line, char separator) const {
    return fields_of(file_, line.number, line.text, separator);
  }

  /// Returns the line where the numbers start; the end of the lines if the text has none.
  [[nodiscard]] std::vector<Line>::const_iterator first_row(const CsvLayout& layout) const {
    return std::ranges::find(lines_, layout.first_line, &Line::number);
  }

  /// True if the numbers of the column may start here.
  [[nodiscard]] bool holds_number(const Line& line, char separator, std::size_t count,
                                  std::size_t column) const {
    if (line.is_comment) return false;
    const auto found = fields(line, separator);
    const bool ends_with_separator = found.size() == count + 1 && found.back().empty();
    return (found.size() == count || ends_with_separator) && number_in_field(found[column]);
  }

  /// True if a line of words directly above the numbers names the column. Lines below it may hold
  /// units. A line with more or fewer words does not name columns: which one is missing is unknown.
  [[nodiscard]] bool is_named_above(const CsvLayout& layout) const {
    const auto first = first_row(layout);
    if (first == lines_.end() || fields(*first, layout.separator).size() != layout.fields) {
      return false;
    }
    for (auto line = first; line != lines_.begin();) {
      const auto found = fields(*--line, layout.separator);
      if (found.size() != layout.fields || !std::ranges::all_of(found, is_word_or_unit)) break;
      const bool has_all = std::ranges::none_of(found, &std::string_view::empty);
      if (has_all && holds_letters(found[layout.column])) return true;
    }
    return false;
  }

  /// Returns the number of words in the line above the numbers; 0 if it holds anything else.
  [[nodiscard]] std::size_t count_names_above(const CsvLayout& layout) const {
    const auto first = first_row(layout);
    if (first == lines_.begin() || first == lines_.end()) return 0;
    const auto names = fields(*(first - 1), layout.separator);
    return std::ranges::all_of(names, is_word_or_unit) ? names.size() : 0;
  }

  [[nodiscard]] static CsvLayout layout_from(const Line& line, char separator, std::size_t count,
                                             std::size_t column) {
    return {.separator = separator,
            .fields = count,
            .column = column,
            .first_line = line.number,
            .numbers = line.from_here};
  }

  /// Requires a line above the numbers to be text; if it has as many fields, the column's field
  /// must be a name.
  void require_text(const Line& line, char separator, std::size_t count, std::size_t column) const {
    if (line.is_comment) return;
    const auto found = fields(line, separator);
    const std::string_view field = found.size() == count ? found[column] : line.text;
    const bool is_named_number = number_in_field(field) && holds_letters(line.text);
    const bool is_empty = field.empty() && holds_letters(line.text);
    const bool is_word = holds_letters(field) && !is_missing_sample(field);
    if (is_word || is_named_number || is_empty || is_date_or_time(field)) return;
    if (numbers_columns(line, separator)) return;
    const std::string_view remedy = remedy_for_thousands(field);
    refuse_csv_line(
        file_, line.number,
        fmt::format("column {} holds {}, neither a number nor a name{}", column_,
                    csv_field_in_quotes(field), remedy.empty() ? "; remove the line" : remedy));
  }

  std::optional<CsvLayout> find_by_number() {
    const std::size_t column = number_in<std::size_t>(column_).value_or(0) - 1;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].is_comment) continue;
      const char separator =
          column == 0 && is_column_of_decimals(i) ? no_separator : separator_of(lines_[i].text);
      const std::size_t count = fields(lines_[i], separator).size();
      if (column >= count || !holds_number(lines_[i], separator, count, column)) continue;
      // A single number among an instrument's text is followed by something else.
      const bool is_alone =
          i + 1 < lines_.size() && !holds_number(lines_[i + 1], separator, count, column);
      if (is_alone && (has_text_before(i) || holds_letters(lines_[i].text))) continue;
      if (is_no_row_of_the_table(lines_[i], separator)) continue;
      for (std::size_t j = 0; j < i; ++j) require_text(lines_[j], separator, count, column);
      return layout_from(lines_[i], separator, count, column);
    }
    return header_alone(column);
  }

  /// True if the lines from here on, ten at least, are one column of numbers with decimal commas,
  /// not two columns of whole numbers, which programs write without a -0 and without a padded 05.
  [[nodiscard]] bool is_column_of_decimals(std::size_t first) const {
    constexpr std::size_t fewest = 10;
    if (lines_.size() < first + fewest) return false;
    bool has_negative_zero = false;
    bool has_padding = false;
    for (std::size_t i = first; i < lines_.size(); ++i) {
      const std::string_view text = trimmed(lines_[i].text, blanks);
      const std::size_t comma = text.find(',');
      if (!number_in_field(text)) return false;
      if (comma == text.npos) continue;
      has_negative_zero = has_negative_zero || text.substr(0, comma) == "-0";
      has_padding = has_padding || (text.size() > comma + 2 && text[comma + 1] == '0');
    }
    return has_negative_zero && has_padding;
  }

  /// True if a line with words, such as "Sample rate,12000", lacks a number that the last line read
  /// has, or if a line numbers the columns, as pandas does: ",0,1,2".
  [[nodiscard]] bool is_no_row_of_the_table(const Line& line, char separator) const {
    if (numbers_columns(line, separator)) return true;
    if (!holds_letters(line.text)) return false;
    const auto found = fields(line, separator);
    const auto last = fields(lines_.back(), separator);
    if (found.size() != last.size()) return true;
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (number_in_field(last[i]) && !number_in_field(found[i])) return true;
    }
    return false;
  }

  [[nodiscard]] bool numbers_columns(const Line& line, char separator) const {
    const auto found = fields(line, separator);
    if (!found.front().empty()) return false;
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (found[i] != std::to_string(i - 1)) return false;
    }
    return !fields(lines_.back(), separator).front().empty();
  }

  /// True if a line has numbers in the same fields as the last line read.
  [[nodiscard]] bool has_numbers_as_last_line(const Line& line, char separator) const {
    const auto is_number = [&](std::string_view field) {
      return number_in_field(field).has_value();
    };
    return std::ranges::equal(fields(line, separator), fields(lines_.back(), separator), {},
                              is_number, is_number);
  }

  /// Returns the number of fields of a row; returns 0 for any other line. Rows of a table with a
  /// column of dates or words have numbers in the same fields as the last line.
  [[nodiscard]] std::size_t count_columns(const Line& line) const {
    const std::size_t numbers = count_numbers(line);
    if (numbers > 0 || line.is_comment) return numbers;
    const char separator = separator_of(line.text);
    const auto found = fields(line, separator);
    const bool has_number =
        std::ranges::any_of(found, [](auto field) { return number_in_field(field).has_value(); });
    return has_number && has_numbers_as_last_line(line, separator) ? found.size() : 0;
  }

  /// Finds the column of times by name or unit; otherwise the first column.
  [[nodiscard]] Times times_in(const CsvLayout& found) const {
    const auto first = first_row(found);
    Times unnamed;
    if (first == lines_.end()) return unnamed;
    for (std::size_t column = 0; column < found.fields; ++column) {
      if (column == found.column || !holds_number(*first, found.separator, found.fields, column)) {
        continue;
      }
      Times times{.column = column + 1};
      for (auto line = lines_.begin(); line != first; ++line) {
        auto names = fields(*line, found.separator);
        if (names.size() != found.fields) names = fields(*line, separator_of(line->text));
        if (names.size() != found.fields) continue;
        const TimeName name = time_name(names[column]);
        times.is_named = times.is_named || name.is_time;
        if (name.unit_s > 0) times.unit_s = name.unit_s;
      }
      if (times.is_named) return times;
      if (column == 0) unnamed = times;
    }
    return unnamed;
  }

  /// Refuses numbers above the samples whose format differs from all samples. Instruments and
  /// programs write such numbers first: the rate, a sensitivity or a column number. Accepts rising
  /// columns, because the first time may be a plain 0, and zeros below a name, because many
  /// programs write 0 without decimals, also between samples.
  void require_no_other_numbers_above(const CsvLayout& found) const {
    constexpr std::size_t most = 10;    // largest number of such numbers
    constexpr std::size_t enough = 10;  // fewest samples that show their format
    std::vector<std::string_view> column;
    for (const Line& line : lines_) {
      if (line.number < found.first_line) continue;
      if (!holds_number(line, found.separator, found.fields, found.column)) return;
      column.push_back(fields(line, found.separator)[found.column]);
    }
    if (column.size() <= enough || rises(column)) return;
    const Form last = form_of(column.back());
    const auto first_where = [&](const auto& is_sample) {
      const auto other = std::find_if_not(column.rbegin(), column.rend(), is_sample);
      return static_cast<std::size_t>(column.rend() - other);
    };
    const std::size_t alike = first_where([&](auto number) { return form_of(number) == last; });
    const std::size_t broken = first_where(
        [](auto number) { return form_of(number).has_decimals || form_of(number).has_exponent; });
    const bool are_whole =
        std::none_of(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(broken),
                     [](auto number) { return form_of(number).has_decimals; });
    for (const auto& [above, counts] :
         {std::pair(alike, last.has_decimals), std::pair(broken, are_whole)}) {
      if (!counts || above == 0 || above > most || column.size() < above + enough) continue;
      const bool is_sample_first = form_of(column.front()) == last;
      const auto is_zero_or_sample = [&](std::string_view number) {
        return number == "0" || number == "-0" || form_of(number) == last;
      };
      if ((found.has_name || is_sample_first) &&
          std::ranges::all_of(std::span(column).first(above), is_zero_or_sample)) {
        continue;
      }
      refuse_csv_line(file_, found.first_line,
                      "column " + column_ + " holds " + csv_field_in_quotes(column.front()) +
                          ", in another format than the numbers below, such as " +
                          csv_field_in_quotes(column.back()) +
                          "; it seems not to be a sample: remove the lines above the table");
    }
  }

  static bool rises(const std::vector<std::string_view>& column) {
    return std::ranges::is_sorted(column, {},
                                  [&](std::string_view number) { return number_in_field(number); });
  }

  [[nodiscard]] bool has_text_before(std::size_t end) const {
    return std::any_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const Line& line) { return !line.is_comment; });
  }

  /// True if the column's field is a date, or a word, next to numbers. The caller refuses it.
  [[nodiscard]] bool holds_other_than_numbers(const Line& line, char separator,
                                              std::size_t column) const {
    const auto found = fields(line, separator);
    return column < found.size() && !number_in_field(found[column]) &&
           std::ranges::any_of(found,
                               [](auto field) { return number_in_field(field).has_value(); });
  }

  /// Refuses text without numbers in all lines that may precede a table. Accepts a column of dates
  /// or words next to numbers.
  void require_numbers(std::size_t column) const {
    const Line& last = lines_.back();
    if (last.number < most_lines_before) return;
    if (holds_other_than_numbers(last, separator_of(last.text), column)) return;
    refuse_csv_line(file_, most_lines_before,
                    "no numbers begin up to this line; remove the lines above the table");
  }

  /// Takes the first line as a header if no line has numbers; the caller refuses the lines below
  /// it.
  std::optional<CsvLayout> header_alone(std::size_t column) {
    require_numbers(column);
    const auto first = std::ranges::find(lines_, false, &Line::is_comment);
    if (first == lines_.end()) return CsvLayout{};
    const char separator = separator_of(first->text);
    const std::size_t count = fields(*first, separator).size();
    if (column >= count) return std::nullopt;
    require_text(*first, separator, count, column);
    return after(static_cast<std::size_t>(first - lines_.begin()), separator, count, column);
  }

  /// Starts below a header and its lines of words, such as units and channels. Skips five such
  /// lines at most, and only the first without a word for the column, because more may be samples
  /// that are missing.
  [[nodiscard]] CsvLayout after(std::size_t header, char separator, std::size_t count,
                                std::size_t column) const {
    constexpr std::size_t most_lines_of_words = 5;
    const std::size_t first = next_line(header);
    std::size_t next = first;
    for (std::size_t i = 0; i < most_lines_of_words && next < lines_.size(); ++i) {
      if (!is_line_of_words(lines_[next], separator, count)) break;
      if (next != first && !holds_letters(fields(lines_[next], separator)[column])) break;
      next = next_line(next);
    }
    const bool has_samples =
        next < lines_.size() && (holds_number(lines_[next], separator, count, column) ||
                                 holds_other_than_numbers(lines_[next], separator, column));
    if (!has_samples) next = first;
    if (next < lines_.size()) return layout_from(lines_[next], separator, count, column);
    return {
        .separator = separator, .fields = count, .column = column, .first_line = 1, .numbers = {}};
  }

  /// Returns the index of the next line without a comment.
  [[nodiscard]] std::size_t next_line(std::size_t line) const {
    do ++line;
    while (line < lines_.size() && lines_[line].is_comment);
    return line;
  }

  [[nodiscard]] bool is_line_of_words(const Line& line, char separator, std::size_t count) const {
    const auto found = fields(line, separator);
    return found.size() == count && std::ranges::all_of(found, is_word_or_unit);
  }

  /// Tries all separators, because a header may have commas while its numbers have tabs. If the
  /// name is in several lines, the header is the line with numbers below it.
  std::optional<CsvLayout> find_by_name() {
    std::optional<std::pair<std::size_t, CsvLayout>> without_numbers;  // header's index first
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (const char separator : {';', '\t', '|', ',', ' '}) {
        const auto header = fields(lines_[i], separator);
        const auto times = std::ranges::count(header, std::string_view(column_));
        if (times > 1) {
          refuse_csv_line(file_, lines_[i].number,
                          "has several columns " + column_ + "; name one by its number");
        }
        if (times == 0) continue;
        const auto place = std::ranges::find(header, std::string_view(column_));
        const auto column = static_cast<std::size_t>(place - header.begin());
        // Trailing separators of a header do not name a column.
        const auto named = std::ranges::find_if(header.rbegin(), header.rend(),
                                                [](auto name) { return !name.empty(); });
        for (const auto count : {header.size(), header.size() - (named - header.rbegin())}) {
          const CsvLayout found = below(i, separator, count, column);
          if (has_numbers(found)) return found;
          if (!without_numbers && !lines_[i].is_comment) without_numbers = {i, found};
        }
      }
    }
    if (!without_numbers) return std::nullopt;
    require_as_many_fields(without_numbers->first, without_numbers->second.fields);
    require_numbers(without_numbers->second.column);
    return without_numbers->second;
  }

  /// Refuses a header that has fewer or more names than the lines below have fields: its names
  /// cannot be assigned to columns.
  void require_as_many_fields(std::size_t header, std::size_t names) const {
    for (std::size_t i = header + 1; i < lines_.size(); ++i) {
      const std::size_t count = count_columns(lines_[i]);
      if (count == 0) continue;
      if (count == names) return;
      refuse_csv_line(file_, lines_[header].number,
                      fmt::format("is a header of {} name{} above lines of {} field{}; name the "
                                  "column by its number, 1 to {}{}",
                                  names, names == 1 ? "" : "s", count, count == 1 ? "" : "s", count,
                                  remedy_for_decimal_commas(names, count, lines_[i].text)));
    }
  }

  [[nodiscard]] CsvLayout below(std::size_t header, char separator, std::size_t count,
                                std::size_t column) const {
    const std::size_t next = next_line(header);
    if (next < lines_.size()) {
      const char other = separator_of(lines_[next].text);
      if (holds_number(lines_[next], other, count, column)) separator = other;
    }
    return after(header, separator, count, column);
  }

  [[nodiscard]] bool has_numbers(const CsvLayout& found) const {
    const auto line = first_row(found);
    return !found.numbers.empty() && line != lines_.end() &&
           holds_number(*line, found.separator, found.fields, found.column);
  }

  /// Refuses the column, with the names in the line above the first numbers, the likeliest header.
  [[noreturn]] void refuse_column() const {
    const Line* header = &lines_.front();
    std::size_t count = 0;
    for (const Line& line : lines_) {
      count = count_columns(line);
      if (count > 0) break;
      header = &line;
    }
    const auto names = fields(*header, separator_of(header->text));
    if (count == 0) count = names.size();
    if (is_column_number(column_)) {
      refuse_csv_line(file_, header->number,
                      "has no column " + column_ + "; columns are 1 to " + std::to_string(count));
    }
    if (header == &lines_.front() && count_columns(*header) > 0) {
      refuse_csv_line(
          file_, header->number,
          fmt::format("has no column {}, because the table lacks a header; name the column "
                      "by its number, 1 to {}",
                      column_, count));
    }
    if (std::ranges::any_of(names, has_control_characters)) {
      refuse_csv_line(
          file_, header->number,
          fmt::format("has no column {}; the file is not in UTF-8, so name the column by its "
                      "number, 1 to {}",
                      column_, count));
    }
    refuse_csv_line(
        file_, header->number,
        "has no column " + column_ + "; it has " + listed({names.begin(), names.end()}));
  }

  const fs::path& file_;
  std::string column_;
  std::vector<Line> lines_;
};

}  // namespace

void refuse_csv_line(const fs::path& file, std::size_t line, const std::string& what) {
  refuse_file(file.string() + ", line " + std::to_string(line), what);
}

void refuse_cut_number(const fs::path& file, std::size_t line, std::string_view number) {
  refuse_csv_line(file, line,
                  "ends the file with " + csv_field_in_quotes(number) +
                      ", with fewer digits than all others and no line end: truncated; get the "
                      "file again, or remove the line");
}

std::string csv_field_in_quotes(std::string_view field) {
  constexpr std::size_t longest = 80;
  if (field.size() <= longest) return "'" + std::string(field) + "'";
  return "'" + std::string(field.substr(0, longest)) + "...'";
}

CsvLayout csv_layout(const fs::path& file, std::string_view text, const std::string& column) {
  return Search(file, text, column).run();
}

}  // namespace piae::raw
