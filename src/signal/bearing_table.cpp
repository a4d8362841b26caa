#include "signal/bearing_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "base/comma_list.hpp"
#include "base/error.hpp"
#include "bearing/kinematics.hpp"
#include "text/csv.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using Keys = std::map<std::string, double>;

const Words header{"designation",
                   "balls",
                   "ball_diameter_mm",
                   "pitch_diameter_mm",
                   "contact_angle_deg",
                   "bpfo",
                   "bpfi",
                   "bsf",
                   "ftf",
                   "source"};

struct Row {
  std::string designation;
  Keys keys;
};

/// Splits "SKF 6205-2RS" into SKF, 6205 and 2RS.
Words words_of(const std::string& designation) {
  Words words(1);
  for (const char c : designation) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte)) {
      words.back() += static_cast<char>(std::toupper(byte));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string joined_words(std::span<const std::string> words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

/// True if the text has at least two digits. A maker or a suffix, such as SKF, C3 or 2RS, has fewer
/// and does not name a bearing.
bool has_number(const std::string& written) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  return std::ranges::count_if(written, is_digit) >= 2;
}

/// Returns all runs of consecutive words, joined.
Words runs_of(const Words& words) {
  Words runs;
  for (std::size_t first = 0; first < words.size(); ++first) {
    for (std::size_t count = 1; first + count <= words.size(); ++count) {
      runs.push_back(joined_words(std::span(words).subspan(first, count)));
    }
  }
  return runs;
}

/// True if consecutive words of the row, joined, equal the requested designation.
bool holds_words(const Words& row, const std::string& written) {
  return std::ranges::count(runs_of(row), written) > 0;
}

/// Returns the numbers of those keys that a row has, from field `first` on.
Keys numbers_at(const text::CsvLine& line, std::span<const char* const> names, std::size_t first) {
  Keys keys;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& field = line.fields[first + i];
    if (field.empty()) continue;
    const auto number = line.number(first + i);
    if (!number) line.refuse("'" + field + "' is not a number");
    keys[names[i]] = *number;
  }
  return keys;
}

std::vector<Row> rows_of(const fs::path& table) {
  if (!fs::exists(table)) {
    throw Error(Exit::input_missing,
                table.string() +
                    ": no such file; copy pipeline/bearings.csv to it, or replace designation by "
                    "dimensions");
  }
  const std::vector<text::CsvLine> lines = text::read_csv(table);
  if (lines.front().fields != header)
    lines.front().refuse("is not the header of a table of bearings");
  std::vector<Row> rows;
  for (const text::CsvLine& line : std::span(lines).subspan(1)) {
    Row row{.designation = line.fields.front(), .keys = numbers_at(line, geometry_keys, 1)};
    if (row.keys.empty()) row.keys = numbers_at(line, order_keys, 1 + geometry_keys.size());
    rows.push_back(std::move(row));
  }
  return rows;
}

/// True if the row has all keys of a geometry, or BPFO and BPFI.
bool has_lines(const Row& row) {
  const auto is_there = [&](const char* key) { return row.keys.contains(key); };
  return std::ranges::all_of(geometry_keys, is_there) || (is_there("bpfo") && is_there("bpfi"));
}

BearingLines lines_of(const Row& row) {
  const Keys& keys = row.keys;
  BearingLines lines{.designation = row.designation};
  if (keys.contains("bpfo")) {
    lines.bpfo = keys.at("bpfo");
    lines.bpfi = keys.at("bpfi");
    if (keys.contains("bsf")) lines.twice_bsf = 2 * keys.at("bsf");
    return lines;
  }
  bearing::Geometry geometry;
  geometry.balls = static_cast<int>(keys.at("balls"));
  geometry.ball_diameter_mm = keys.at("ball_diameter_mm");
  geometry.pitch_diameter_mm = keys.at("pitch_diameter_mm");
  geometry.contact_angle_deg = keys.at("contact_angle_deg");
  const auto f = bearing::fault_frequencies(geometry, 60);
  lines.bpfo = f.bpfo_hz;
  lines.bpfi = f.bpfi_hz;
  lines.twice_bsf = 2 * f.bsf_hz;
  return lines;
}

bool have_the_same_lines(const Row& a, const Row& b) {
  const BearingLines one = lines_of(a);
  const BearingLines other = lines_of(b);
  return std::abs(one.bpfo / other.bpfo - 1) < 0.01 && std::abs(one.bpfi / other.bpfi - 1) < 0.01;
}

std::string designations_of(const std::vector<Row>& rows) {
  return comma_list(rows, &Row::designation);
}

std::string_view number_at_end(std::string_view word) {
  return word.substr(word.find_last_not_of("0123456789") + 1);  // npos + 1 is 0
}

/// True if a word ends with a bearing's number and the 2 of a seal: 62052RS is a 6205 with 2RS.
/// False if the 2 may belong to the bearing, as in 6202Z, or in 62202RS of the wide series 622.
bool ends_with_two_of_seal(std::string_view word) {
  const std::string_view number = number_at_end(word);
  const auto starts_with = [&](std::string_view series) { return number.starts_with(series); };
  constexpr std::array<std::string_view, 6> series{"60", "62", "63", "64", "68", "69"};
  constexpr std::array<std::string_view, 4> wide{"622", "623", "630", "638"};
  const bool has_five_digits = number.size() == 5 && std::ranges::any_of(series, starts_with) &&
                               std::ranges::none_of(wide, starts_with);
  return number.ends_with('2') && (has_five_digits || number.size() == 6);
}

/// Removes marks of seals, shields and clearance, which change no dimension: 6205-2Z/C3, 6205ZZ and
/// 62052RS are a 6205.
Words without_suffixes(const Words& words) {
  constexpr std::array<std::string_view, 29> attached{
      "ZZ",  "RZ",  "ZR",  "Z",   "RS",  "RS1", "RS2", "RSH", "RSL", "RSR",
      "RSD", "HRS", "BRS", "LLU", "LLB", "LLH", "LU",  "DDU", "DD",  "DU",
      "VV",  "RU",  "NSE", "C2",  "C3",  "C4",  "C5",  "CN",  "CM"};
  constexpr std::array<std::string_view, 17> apart{"P0",   "P5",   "P6",   "2Z",   "2ZR",  "2RS",
                                                   "2RS1", "2RS2", "2RSH", "2RSL", "2RSR", "2RSD",
                                                   "2RZ",  "2HRS", "2BRS", "2RU",  "2NSE"};
  Words found;
  for (const std::string& word : words) {
    std::string_view stem = word;
    for (bool again = true; again;) {
      again = false;
      if (std::ranges::count(apart, stem) > 0) stem = "";
      for (const std::string_view suffix : attached) {
        if (!stem.ends_with(suffix)) continue;
        stem.remove_suffix(suffix.size());
        if (!suffix.starts_with('C') && ends_with_two_of_seal(stem)) stem.remove_suffix(1);
        again = true;
      }
    }
    if (stem.empty()) continue;
    const bool ends_with_digit = std::isdigit(static_cast<unsigned char>(stem.back())) != 0;
    found.push_back(ends_with_digit ? std::string(stem) : word);
  }
  return found;
}

/// Returns the rows whose whole designation matches. Without such a row, returns those that contain
/// its words; otherwise those that do so apart from suffixes.
std::vector<Row> rows_called(const Words& written, const std::vector<Row>& rows) {
  std::vector<Row> whole;
  std::vector<Row> part;
  std::vector<Row> stem;
  const std::string all = joined_words(written);
  const std::string all_stems = joined_words(without_suffixes(written));
  for (const Row& row : rows) {
    const Words words = words_of(row.designation);
    if (joined_words(words) == all) whole.push_back(row);
    if (!has_number(all_stems)) continue;  // 2RS1 has two digits, but is a seal
    if (holds_words(words, all)) part.push_back(row);
    if (holds_words(without_suffixes(words), all_stems)) stem.push_back(row);
  }
  if (!whole.empty()) return whole;
  return part.empty() ? stem : part;
}

/// Returns 6204 for an insert bearing UC204 and a unit with it, such as UCP204; empty for others.
/// Inserts are deep groove ball bearings of series 62 and 63 with a wide inner ring. Those below
/// 204 are left out, because some have the outer ring of a 204.
std::string deep_groove_of(std::string_view word) {
  const std::string_view number = number_at_end(word);
  const bool is_insert = word.starts_with("UC") && number.size() == 3 &&
                         (number[0] == '2' || number[0] == '3') && number.substr(1) >= "04";
  return is_insert ? '6' + std::string(number) : "";
}

/// Returns the deep groove bearing with the rolling elements of an insert bearing among the words;
/// empty without such a word.
std::string deep_groove_among(const Words& words) {
  for (const std::string& word : words) {
    if (std::string bearing = deep_groove_of(word); !bearing.empty()) return bearing;
  }
  return {};
}

/// Returns the rows that share the bearing's number with the request, as a hint; without a number
/// in the request, the rows that share a word.
std::vector<Row> rows_like(const Words& written, const std::vector<Row>& rows) {
  const Words runs = runs_of(without_suffixes(written));
  const bool has_any_number = std::ranges::any_of(runs, has_number);
  std::vector<Row> like;
  for (const Row& row : rows) {
    const Words words = words_of(row.designation);
    const Words row_stems = without_suffixes(words);
    const bool shares_a_run = std::ranges::any_of(runs, [&](const std::string& run) {
      return has_number(run) && holds_words(row_stems, run);
    });
    const bool shares_a_word = std::ranges::find_first_of(words, written) != words.end();
    if (has_any_number ? shares_a_run : shares_a_word) like.push_back(row);
  }
  return like;
}

}  // namespace

Keys bearing_called(const std::string& designation, const fs::path& table) {
  const std::vector<Row> rows = rows_of(table);
  const Words words = words_of(designation);
  const std::vector<Row> found = rows_called(words, rows);
  if (found.empty()) {
    const std::string insert = deep_groove_among(words);
    const Words sought = insert.empty() ? words : Words{insert};
    const std::string like = designations_of(rows_like(sought, rows));
    throw Error(Exit::bad_input,
                "'" + designation + "' has no row in " + table.string() +
                    (like.empty() ? "" : "; similar are " + like) +
                    (insert.empty() ? ""
                                    : "; an insert usually has the rolling elements of the deep "
                                      "groove bearing " +
                                          insert) +
                    "; give balls, ball_diameter_mm, pitch_diameter_mm and contact_angle_deg, or "
                    "bpfo and bpfi, from a data sheet; or remove [bearing], and write defect = "
                    "\"other\" for all faults");
  }
  for (const Row& row : found) {
    if (have_the_same_lines(row, found.front())) continue;
    throw Error(Exit::bad_input, "'" + designation + "' may mean " + designations_of(found) +
                                     ", whose fault lines differ; name one of them");
  }
  return found.front().keys;
}

std::vector<BearingLines> lines_of_bearings(const fs::path& table) {
  std::vector<BearingLines> lines;
  if (!fs::exists(table)) return lines;
  for (const Row& row : rows_of(table)) {
    if (has_lines(row)) lines.push_back(lines_of(row));
  }
  return lines;
}

}  // namespace piae::signal
