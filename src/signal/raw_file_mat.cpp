#include <matio.h>

#include <cstdint>
#include <memory>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "signal/raw_file.hpp"

namespace piae::signal {

namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Close>;
using Variable = std::unique_ptr<matvar_t, Close>;

std::uint32_t number_at(const std::vector<std::byte>& bytes, std::size_t at, bool big_endian) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + (big_endian ? i : 3 - i)]);
  }
  return number;
}

/// Whether a file of version 5 is complete. libmatio does not say when it is truncated, but fills
/// up the missing values. Such a file is a header of 128 bytes and then one element after another,
/// each with its type and size (4 bytes each) and its content.
bool is_whole_v5(const fs::path& path) {
  const std::vector<std::byte> bytes = artefact::read_file(path);
  const bool big_endian = bytes[126] == std::byte{'M'};  // "MI", and "IM" otherwise
  std::size_t at = 128;
  while (at + 8 <= bytes.size()) at += 8 + number_at(bytes, at + 4, big_endian);
  return at == bytes.size();
}

File open(const fs::path& path) {
  File file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  const mat_ft version = file ? Mat_GetVersion(file.get()) : MAT_FT_UNDEFINED;
  const bool v5 = version == MAT_FT_MAT5 && is_whole_v5(path);
  if (!v5 && version != MAT_FT_MAT73) {
    refuse_raw_file(path, "truncated, damaged or not a MATLAB file of version 5 or 7.3");
  }
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

[[noreturn]] void refuse_missing(const fs::path& path, const std::string& wanted) {
  std::string list;
  for (const std::string& name : names_in(path)) {
    if (name == wanted) refuse_raw_file(path, "variable " + wanted + " is damaged or truncated");
    list += (list.empty() ? "" : ", ") + name;
  }
  refuse_raw_file(path, "has no variable " + wanted + "; it has " + (list.empty() ? "none" : list));
}

std::size_t length_of(const fs::path& path, const matvar_t& variable) {
  std::size_t count = 1;
  std::size_t longest = 1;
  for (int i = 0; i < variable.rank; ++i) {
    count *= variable.dims[i];
    longest = std::max(longest, variable.dims[i]);
  }
  if (variable.isComplex != 0 || (count > 0 && count != longest)) {
    refuse_raw_file(path, std::string("variable ") + variable.name + " is not a real vector");
  }
  return count;
}

template <class T>
std::vector<double> convert(const matvar_t& variable, std::size_t count) {
  const auto* first = static_cast<const T*>(variable.data);
  return {first, first + count};
}

std::vector<double> numbers_of(const fs::path& path, const matvar_t& variable) {
  const std::size_t count = length_of(path, variable);
  if (count == 0) return {};
  if (variable.data == nullptr) refuse_missing(path, variable.name);
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return convert<double>(variable, count);
    case MAT_C_SINGLE:
      return convert<float>(variable, count);
    case MAT_C_INT8:
      return convert<std::int8_t>(variable, count);
    case MAT_C_UINT8:
      return convert<std::uint8_t>(variable, count);
    case MAT_C_INT16:
      return convert<std::int16_t>(variable, count);
    case MAT_C_UINT16:
      return convert<std::uint16_t>(variable, count);
    case MAT_C_INT32:
      return convert<std::int32_t>(variable, count);
    case MAT_C_UINT32:
      return convert<std::uint32_t>(variable, count);
    case MAT_C_INT64:
      return convert<std::int64_t>(variable, count);
    case MAT_C_UINT64:
      return convert<std::uint64_t>(variable, count);
    default:
      refuse_raw_file(path, std::string("variable ") + variable.name + " does not hold numbers");
  }
}

}  // namespace

std::vector<double> read_mat(const fs::path& path, const std::string& name) {
  const File file = open(path);
  const Variable variable(Mat_VarRead(file.get(), name.c_str()));
  if (!variable) refuse_missing(path, name);
  return numbers_of(path, *variable);
}

}  // namespace piae::signal
