#include "formats/mat.hpp"

#include <limits>

#include "base/error.hpp"
#include "formats/bytes.hpp"

namespace piae::formats {

namespace {

/// Types of elements (mi...) and classes of arrays (mx...), with the numbers of MATLAB's format
/// description.
enum Element : std::uint32_t {
  element_int8 = 1,
  element_uint16 = 4,
  element_int32 = 5,
  element_uint32 = 6,
  element_single = 7,
  element_double = 9,
  element_matrix = 14
};
enum ArrayClass : std::uint32_t {
  array_cell = 1,
  array_char = 4,
  array_double = 6,
  array_single = 7
};

constexpr std::size_t unit = 8;                // alignment of every element
constexpr std::size_t room_for_header = 1024;  // more than the header of any array
constexpr std::size_t largest_variable = std::numeric_limits<std::int32_t>::max();

/// Writes an element: its type, its size, its content, and zeros up to the next element.
void put(Bytes& bytes, Element type, const std::string& content) {
  bytes.number(static_cast<std::uint32_t>(type));
  bytes.number(static_cast<std::uint32_t>(content.size()));
  bytes.text(content);
  bytes.pad(unit);
}

template <class Values>
std::string content_of(const Values& values) {
  Bytes bytes;
  for (const auto value : values) bytes.number(value);
  return bytes.take();
}

/// Returns the beginning of an array.
Bytes begin_array(ArrayClass type, std::size_t rows, std::size_t columns, const std::string& name) {
  Bytes bytes;
  put(bytes, element_uint32, content_of(std::vector<std::uint32_t>{type, 0}));
  put(bytes, element_int32,
      content_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(rows),
                                            static_cast<std::uint32_t>(columns)}));
  put(bytes, element_int8, name);
  return bytes;
}

std::string text_array(const std::string& name, const std::string& text) {
  Bytes bytes = begin_array(array_char, 1, text.size(), name);
  std::vector<std::uint16_t> units;
  for (const char c : text) units.push_back(static_cast<unsigned char>(c));
  put(bytes, element_uint16, content_of(units));
  return bytes.take();
}

std::string number_array(const std::string& name, const Numbers& values, std::size_t rows,
                         std::size_t columns) {
  Bytes bytes = begin_array(array_double, rows, columns, name);
  put(bytes, element_double, content_of(values));
  return bytes.take();
}

/// Returns a column of cells; make(index) makes each cell.
template <class MakeCell>
std::string cell_array(const std::string& name, std::size_t cells, const MakeCell& make) {
  Bytes bytes = begin_array(array_cell, cells, 1, name);
  for (std::size_t i = 0; i < cells; ++i) put(bytes, element_matrix, make(i));
  return bytes.take();
}

std::string column(const Fact& fact) {
  if (const auto* numbers = std::get_if<Numbers>(&fact.values)) {
    return number_array(fact.name, *numbers, numbers->size(), 1);
  }
  if (const auto* texts = std::get_if<Texts>(&fact.values)) {
    return cell_array(fact.name, texts->size(),
                      [&](std::size_t i) { return text_array("", (*texts)[i]); });
  }
  const auto& lists = std::get<Lists>(fact.values);
  return cell_array(fact.name, lists.size(), [&](std::size_t i) {
    return number_array("", lists[i], lists[i].empty() ? 0 : 1, lists[i].size());
  });
}

std::string single_value(const Fact& fact) {
  if (const auto* texts = std::get_if<Texts>(&fact.values)) {
    return text_array(fact.name, texts->front());
  }
  return number_array(fact.name, std::get<Numbers>(fact.values), 1, 1);
}

/// Writes column after column, as MATLAB stores a matrix.
std::string window_array(const signal::WindowSet& windows) {
  Bytes bytes = begin_array(array_single, windows.size(), windows.length, "windows");
  Bytes samples;
  for (std::size_t t = 0; t < windows.length; ++t) {
    for (std::size_t i = 0; i < windows.size(); ++i) samples.number(windows.window(i)[t]);
  }
  put(bytes, element_single, samples.all());
  return bytes.take();
}

std::string header() {
  constexpr std::size_t description = 116;
  constexpr std::size_t with_offset_of_subsystem = 124;
  std::string text = "MATLAB 5.0 MAT-file, windows exported by PIAE-DT";
  text.resize(description, ' ');
  text.resize(with_offset_of_subsystem, '\0');
  Bytes bytes;
  bytes.text(text);
  bytes.number(std::uint16_t{0x0100});  // version
  bytes.text("IM");                     // little-endian
  return bytes.take();
}

}  // namespace

std::string mat(const Exported& exported) {
  constexpr std::size_t most_samples = (largest_variable - room_for_header) / sizeof(float);
  if (exported.windows.samples.size() > most_samples) {
    throw Error(
        Exit::usage,
        "a .mat file of version 5 holds no variable of more than 2 GB; export fewer windows "
        "with --count or --class, or .npy");
  }
  const Facts facts = facts_of(exported);
  Bytes bytes;
  bytes.text(header());
  put(bytes, element_matrix, window_array(exported.windows));
  for (const Fact& fact : facts.of_each) put(bytes, element_matrix, column(fact));
  for (const Fact& fact : facts.of_all) put(bytes, element_matrix, single_value(fact));
  return bytes.take();
}

}  // namespace piae::formats
