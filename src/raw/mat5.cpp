#include <matio.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "signal/raw_file.hpp"
#include "signal/raw_limits.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Close>;
using Variable = std::unique_ptr<matvar_t, Close>;

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at, bool big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + (big_endian ? i : 3 - i)]);
  }
  return number;
}

/// How a file of either version begins: text, and then the version and "MI" or "IM", for the order
/// of bytes. libmatio is given no other file: it takes those of version 4 at their word.
constexpr std::size_t header_size = 128;

bool is_big_endian(std::span<const std::byte> bytes) { return bytes[126] == std::byte{'M'}; }

int version_of(std::span<const std::byte> bytes) {
  if (bytes.size() < header_size) return 0;
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  if (at(126) == 'M' && at(127) == 'I') return at(124) * 256 + at(125);
  if (at(126) == 'I' && at(127) == 'M') return at(125) * 256 + at(124);
  return 0;
}

/// Whether a file of version 5 is complete. libmatio does not say when it is truncated, but fills
/// up the missing values. Such a file is a header of 128 bytes and then one element after another,
/// each with its type and size (4 bytes each) and its content.
bool is_whole_v5(std::span<const std::byte> bytes) {
  const bool big_endian = is_big_endian(bytes);
  std::size_t at = header_size;
  while (at + 8 <= bytes.size()) at += 8 + number_at(bytes, at + 4, big_endian);
  return at == bytes.size();
}

/// Refuses what cannot be read, before libmatio sees it.
mat_ft require_readable(const fs::path& path) {
  const Bytes bytes = artefact::read_file(path);
  const int version = version_of(bytes);
  if (version == MAT_FT_MAT73 || (version == MAT_FT_MAT5 && is_whole_v5(bytes))) {
    return static_cast<mat_ft>(version);
  }
  refuse_raw_file(path, "truncated, damaged or not a MATLAB file of version 5 or 7.3");
}

/// The message is a `char*` in matio 1.5.23 (Debian 12), and a `const char*` in 1.5.28 (Debian 13).
template <class Char>
void print_nothing(int /*level*/, Char* /*message*/) {}

File open(const fs::path& path) {
  Mat_LogInitFunc("", print_nothing);
  File file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) refuse_raw_file(path, "truncated, damaged or not a MATLAB file of version 5 or 7.3");
  return file;
}

std::vector<std::string> names_in(const fs::path& path) {
  const File file = open(path);
  std::vector<std::string> names;
  while (const Variable variable{Mat_VarReadNextInfo(file.get())}) {
    if (variable->name != nullptr) names.emplace_back(variable->name);
  }
  return names;
}

[[noreturn]] void refuse_missing_variable(const fs::path& path, const std::string& wanted) {
  const std::vector<std::string> names = names_in(path);
  if (std::ranges::find(names, wanted) != names.end()) {
    refuse_raw_file(path, "variable " + wanted + " is damaged or truncated");
  }
  refuse_raw_file(path, "has no variable " + wanted + "; it has " + listed(names));
}

std::size_t length_of(const fs::path& path, const matvar_t& variable) {
  const std::string name = std::string("variable ") + variable.name;
  if (variable.isComplex != 0) refuse_raw_file(path, name + " is not a real vector");
  return vector_length(path, name, variable.dims, static_cast<std::size_t>(variable.rank));
}

template <class T>
std::vector<double> convert(const fs::path& path, const matvar_t& variable, std::size_t count) {
  if (variable.nbytes / sizeof(T) < count) refuse_missing_variable(path, variable.name);
  const auto* first = static_cast<const T*>(variable.data);
  return {first, first + count};
}

std::vector<double> numbers_of(const fs::path& path, const matvar_t& variable, std::size_t count) {
  if (variable.data == nullptr) refuse_missing_variable(path, variable.name);
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return convert<double>(path, variable, count);
    case MAT_C_SINGLE:
      return convert<float>(path, variable, count);
    case MAT_C_INT8:
      return convert<std::int8_t>(path, variable, count);
    case MAT_C_UINT8:
      return convert<std::uint8_t>(path, variable, count);
    case MAT_C_INT16:
      return convert<std::int16_t>(path, variable, count);
    case MAT_C_UINT16:
      return convert<std::uint16_t>(path, variable, count);
    case MAT_C_INT32:
      return convert<std::int32_t>(path, variable, count);
    case MAT_C_UINT32:
      return convert<std::uint32_t>(path, variable, count);
    case MAT_C_INT64:
      return convert<std::int64_t>(path, variable, count);
    case MAT_C_UINT64:
      return convert<std::uint64_t>(path, variable, count);
    default:
      refuse_raw_file(path, std::string("variable ") + variable.name + " does not hold numbers");
  }
}

}  // namespace

std::vector<double> read_mat(const fs::path& path, const std::string& name) {
  if (require_readable(path) == MAT_FT_MAT73) require_own_vector(path, name);
  const File file = open(path);
  const Variable variable(Mat_VarReadInfo(file.get(), name.c_str()));
  if (!variable) refuse_missing_variable(path, name);
  const std::size_t count = length_of(path, *variable);
  if (count == 0) return {};
  if (Mat_VarReadDataAll(file.get(), variable.get()) != 0) refuse_missing_variable(path, name);
  return numbers_of(path, *variable, count);
}

}  // namespace piae::signal
