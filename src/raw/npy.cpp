#include "raw/npy.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "artefact/file.hpp"
#include "base/numbers.hpp"
#include "raw/array.hpp"
#include "raw/bytes.hpp"
#include "raw/file.hpp"
#include "raw/limits.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

/// Header of the array: {'descr': '<f8', 'fortran_order': False, 'shape': (3, 24000), }
struct Header {
  char byte_order = '<';
  std::string type;  ///< "f8"
  bool is_fortran = false;
  Shape shape;
  std::size_t size = 0;  ///< bytes before the values
};

[[noreturn]] void refuse_header(const fs::path& file) {
  refuse_file(file, "truncated, damaged or not a NumPy file: its header cannot be read");
}

/// Returns the text after a key, up to one of `ends`.
std::string_view value_of(std::string_view header, std::string_view key, std::string_view ends) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  const std::size_t begin = header.find_first_not_of(" :", at + key.size());
  if (begin == std::string_view::npos) return {};
  return header.substr(begin, header.find_first_of(ends, begin + 1) - begin);
}

std::optional<Shape> parse_shape(std::string_view text) {
  Shape shape;
  if (!text.starts_with('(')) return std::nullopt;
  text.remove_prefix(1);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view extent = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (extent.starts_with(' ')) extent.remove_prefix(1);
    if (extent.empty()) continue;
    const auto number = number_in<std::size_t>(extent);
    if (!number) return std::nullopt;
    shape.push_back(*number);
  }
  return shape;
}

Header header_of(const fs::path& file, std::string_view bytes) {
  constexpr std::size_t before = 10;  // mark, version, length of the header
  if (bytes.size() < before + 2) refuse_header(file);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const bool is_first_version = byte(6) == 1;
  const std::size_t begin = is_first_version ? before : before + 2;
  std::size_t length = byte(8) | byte(9) << 8U;
  if (!is_first_version)
    length |= static_cast<std::size_t>(byte(10)) << 16U | static_cast<std::size_t>(byte(11)) << 24U;
  if (begin + length > bytes.size()) refuse_header(file);
  const std::string_view text = bytes.substr(begin, length);
  const std::string_view type = value_of(text, "'descr'", "',");
  const auto shape = parse_shape(value_of(text, "'shape'", ")"));
  const std::string_view order = value_of(text, "'fortran_order'", ",}");
  if (!shape || (order != "True" && order != "False")) refuse_header(file);
  if (type.size() < 3 || type[0] != '\'') {
    const std::size_t name = text.find("[('");
    const std::string_view field = name == text.npos ? "" : text.substr(name + 3);
    refuse_file(file, fmt::format("is a NumPy record array; save one of its fields: "
                                  "np.save('x.npy', a['{}'])",
                                  field.empty() ? "FIELD" : field.substr(0, field.find('\''))));
  }
  return {.byte_order = type[1],
          .type = std::string(type.substr(2)),
          .is_fortran = order == "True",
          .shape = *shape,
          .size = begin + length};
}

/// Reads an IEEE 754 binary16 number.
double half_at(std::span<const std::byte> bytes, std::size_t at, bool big_endian) {
  const auto bits = number_at<std::uint16_t>(bytes, at, big_endian);
  const int exponent = bits >> 10U & 0x1F;
  const double fraction = bits & 0x3FFU;
  const double sign = (bits & 0x8000U) != 0 ? -1 : 1;
  if (exponent == 0x1F) {
    return fraction == 0 ? sign * std::numeric_limits<double>::infinity()
                         : std::numeric_limits<double>::quiet_NaN();
  }
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(1 + fraction / 1024, exponent - 15);
}

using Convert = double (*)(std::span<const std::byte> bytes, std::size_t at, bool big_endian);
struct Type {
  const char* name;
  std::size_t size;
  Convert convert;
};
constexpr std::array types{Type{"f8", 8, double_at<double>},
                           Type{"f4", 4, double_at<float>},
                           Type{"f2", 2, half_at},
                           Type{"i1", 1, double_at<std::int8_t>},
                           Type{"u1", 1, double_at<std::uint8_t>},
                           Type{"i2", 2, double_at<std::int16_t>},
                           Type{"u2", 2, double_at<std::uint16_t>},
                           Type{"i4", 4, double_at<std::int32_t>},
                           Type{"u4", 4, double_at<std::uint32_t>},
                           Type{"i8", 8, double_at<std::int64_t>},
                           Type{"u8", 8, double_at<std::uint64_t>}};

/// Names an unsupported type for the error.
const char* words_for(std::string_view type) {
  switch (type.front()) {
    case 'c':
      return "complex numbers";
    case 'b':
      return "booleans";
    case 'O':
      return "Python objects";
    case 'U':
    case 'S':
      return "text";
    case 'M':
    case 'm':
      return "times";
    default:
      return "values of an unknown type";
  }
}

std::vector<double> numbers_in(std::span<const std::byte> values, const Type& type,
                               bool big_endian) {
  std::vector<double> numbers(values.size() / type.size);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = type.convert(values, i * type.size, big_endian);
  }
  return numbers;
}

}  // namespace

std::vector<double> read_npy(const fs::path& file, const std::string& variable) {
  const Bytes content = artefact::read_file(file, largest_bytes);
  const std::string_view bytes(reinterpret_cast<const char*>(content.data()), content.size());
  const Header header = header_of(file, bytes);
  const auto type = std::ranges::find(types, header.type, &Type::name);
  if (type == types.end()) {
    const bool is_complex = header.type.starts_with('c');
    refuse_file(file, fmt::format("holds {} (NumPy type '{}'), which is not supported; save {}",
                                  words_for(header.type), header.type,
                                  is_complex ? "its real part: np.save('x.npy', a.real)"
                                             : "numbers: np.save('x.npy', a.astype('f8'))"));
  }
  std::string name = variable;
  const auto line = take_matrix_line(name);
  if (!name.empty() && (line || name != "1")) {
    refuse_file(file, fmt::format("has no variable {}: it holds one array; name it 1, or name a "
                                  "row (1,:) or a column (:,1) of a matrix",
                                  variable));
  }
  const Where where{.file = file, .noun = "array", .name = ""};
  const std::size_t count = possible_count(where, header.shape);
  const auto values = std::span<const std::byte>(content).subspan(header.size);
  if (values.size() != count * type->size) {
    refuse_file(file, fmt::format("truncated or damaged: {} bytes of values, {} expected",
                                  values.size(), count * type->size));
  }
  return vector_of(where,
                   {.shape = header.shape,
                    .is_column_major = header.is_fortran,
                    .numbers = [&] { return numbers_in(values, *type, header.byte_order == '>'); }},
                   line);
}

}  // namespace piae::raw
