#include "raw/uff.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "artefact/file.hpp"
#include "base/numbers.hpp"
#include "raw/array.hpp"
#include "raw/bytes.hpp"
#include "raw/csv_fields.hpp"
#include "raw/csv_layout.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"
#include "raw/text.hpp"
#include "raw/uff_functions.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

constexpr int general = 0;
constexpr int time_response = 1;
constexpr int unknown_abscissa = 0;
constexpr int time_abscissa = 17;
constexpr int single_real = 2;
constexpr int double_real = 4;

/// Names of the function types 0 to 12.
constexpr std::array function_names{"a function of an unknown type",
                                    "a time response",
                                    "an auto spectrum",
                                    "a cross spectrum",
                                    "a frequency response function",
                                    "a transmissibility",
                                    "a coherence",
                                    "an auto correlation",
                                    "a cross correlation",
                                    "a power spectral density",
                                    "an energy spectral density",
                                    "a probability density function",
                                    "a spectrum"};

/// Refuses a function that is not a time record with even spacing.
void require_time_record(const Where& where, const UffFunction& function) {
  const auto type = static_cast<std::size_t>(function.function_type);
  if (function.function_type != general && function.function_type != time_response) {
    refuse(where,
           fmt::format("is {}, not a time record", type < function_names.size()
                                                       ? std::string(function_names.at(type))
                                                       : fmt::format("of function type {}", type)));
  }
  if (function.abscissa_type != unknown_abscissa && function.abscissa_type != time_abscissa) {
    refuse(where, fmt::format("is not a function of time: its abscissa has the type {}",
                              function.abscissa_type));
  }
  if (function.ordinate_type != single_real && function.ordinate_type != double_real) {
    refuse(where, "holds complex numbers or numbers of an unknown type; export real ones");
  }
  if (!function.is_even) {
    refuse(where, "has uneven spacing: export it with a constant sample rate");
  }
}

std::vector<double> binary_values(const Where& where, const UffFunction& function) {
  const bool is_single = function.ordinate_type == single_real;
  const std::size_t size = is_single ? sizeof(float) : sizeof(double);
  const std::span bytes = std::as_bytes(std::span(function.values));
  if (function.count != bytes.size() / size || bytes.size() % size != 0) {
    refuse(where, fmt::format("is truncated or damaged: {} bytes of values, {} values expected",
                              bytes.size(), function.count));
  }
  std::vector<double> values(function.count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = is_single ? double_at<float>(bytes, i * size, function.is_big_endian)
                          : double_at<double>(bytes, i * size, function.is_big_endian);
  }
  return values;
}

/// Reads a number in Fortran format, possibly with a D before its exponent.
std::optional<double> fortran_number(std::string_view field) {
  std::string text(field.starts_with('+') ? field.substr(1) : field);
  for (char& c : text) c = c == 'D' || c == 'd' ? 'E' : c;
  return number_in<double>(text);
}

/// Reads the numbers of a line, separated by blanks or in fields of fixed width. A number that
/// fills its field has no blank before it. Returns nothing if a number is not readable.
std::optional<std::vector<double>> numbers_in_line(std::string_view line, std::size_t width) {
  std::vector<double> numbers;
  while (!line.empty()) {
    const std::size_t end = width > 0 ? width : line.find_first_of(blanks);
    const auto number = fortran_number(trimmed(line.substr(0, end), blanks));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    line.remove_prefix(std::min(end, line.size()));
    if (width == 0) line = trimmed(line, blanks);
  }
  return numbers;
}

std::vector<double> text_values(const Where& where, const UffFunction& function) {
  constexpr std::size_t single_width = 13;  // E13.5
  constexpr std::size_t double_width = 20;  // E20.12
  const std::size_t width = function.ordinate_type == single_real ? single_width : double_width;
  std::vector<double> values;
  std::size_t number = function.first_line;
  for (std::string_view rest = function.values; !rest.empty(); ++number) {
    std::string_view line = take_line(rest);
    line = line.substr(0, line.find_last_not_of(blanks) + 1);
    auto numbers = numbers_in_line(trimmed(line, blanks), 0);
    if (!numbers) numbers = numbers_in_line(line, width);
    if (!numbers) {
      refuse(where, fmt::format("has a line {} that does not hold numbers {} columns wide: {}",
                                number, width, csv_field_in_quotes(trimmed(line, blanks))));
    }
    values.insert(values.end(), numbers->begin(), numbers->end());
  }
  if (values.size() != function.count) {
    refuse(where, fmt::format("is truncated or damaged: {} values, {} expected", values.size(),
                              function.count));
  }
  return values;
}

const UffFunction& function_called(const fs::path& file, const std::vector<UffFunction>& functions,
                                   const std::string& wanted) {
  const auto number = number_in<std::size_t>(wanted);
  if (number && *number >= 1 && *number <= functions.size()) return functions[*number - 1];
  const UffFunction* found = nullptr;
  std::vector<std::string> names;
  for (const UffFunction& function : functions) {
    names.push_back(fmt::format("{} ({})", names.size() + 1, function.name));
    if (function.name != wanted) continue;
    if (found != nullptr) {
      refuse_file(file, fmt::format("has several data sets {}; name one by its number, 1 to {}",
                                    wanted, functions.size()));
    }
    found = &function;
  }
  if (found == nullptr)
    refuse_file(file, "has no data set " + wanted + "; it has " + listed(names));
  return *found;
}

std::string uff_text(const fs::path& file) {
  const Bytes bytes = artefact::read_file(file, largest_bytes);
  return without_byte_order_mark({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace

bool is_uff(std::string_view beginning) {
  const std::string_view mark = take_line(beginning);
  if (!mark.starts_with("    -1") || !trimmed(mark.substr(6), blanks).empty()) return false;
  const std::string_view line = take_line(beginning);
  const auto type = number_in<int>(trimmed(line.substr(0, 6), blanks));
  const bool ends = line.size() <= 6 || line[6] == ' ' || line[6] == 'b';
  // Columns of integers may start alike, so accept only the types that files start with.
  constexpr std::array types{15, 18, 55, 56, 57, 58, 82, 151, 164, 1858};
  return type && ends && line.size() >= 6 &&
         (std::ranges::count(types, *type) > 0 || (*type >= 2400 && *type < 2500));
}

Signal read_uff(const fs::path& file, const std::string& variable) {
  const std::string text = uff_text(file);
  const std::vector<UffFunction> functions = uff_functions(file, text);
  const UffFunction& function = function_called(file, functions, variable);
  const Where where{.file = file, .noun = "data set", .name = variable};
  require_time_record(where, function);
  Signal signal{.samples = function.is_binary ? binary_values(where, function)
                                              : text_values(where, function)};
  if (function.increment > 0) signal.sample_rate_hz = 1 / function.increment;
  return signal;
}

}  // namespace piae::raw
