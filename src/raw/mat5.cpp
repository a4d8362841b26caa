#include <matio.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include "artefact/file.hpp"
#include "base/error.hpp"
#include "raw/file.hpp"
#include "raw/mat_elements.hpp"
#include "raw/node.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

constexpr const char* what_objects_are =
    "a MATLAB object, such as a table; export its values: x = T.Var1; save('x.mat', 'x')";

struct Close {
  void operator()(mat_t* file) const { Mat_Close(file); }
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using File = std::unique_ptr<mat_t, Close>;
using Variable = std::unique_ptr<matvar_t, Close>;

[[noreturn]] void refuse_unreadable(const fs::path& path) {
  refuse_file(path, "truncated, damaged or not a MATLAB file of version 5 or 7.3");
}

/// Returns the version of a file that libmatio can read safely; refuses others.
mat_ft readable_version(const fs::path& path, std::span<const std::byte> bytes) {
  const int version = mat_version(bytes);
  if (version == MAT_FT_MAT73 || (version == MAT_FT_MAT5 && is_whole_v5(bytes))) {
    return static_cast<mat_ft>(version);
  }
  refuse_unreadable(path);
}

void require_intact(const fs::path& path, std::span<const std::byte> bytes) {
  const std::string flaw = flaw_of_v5(bytes);
  if (!flaw.empty()) refuse_file(path, "is damaged: " + flaw + "; get it again");
}

/// Ignores a message: a `char*` in matio 1.5.23 (Debian 12), a `const char*` in 1.5.28 (Debian 13).
template <class Char>
void print_nothing(int /*level*/, Char* /*message*/) {}

File open(const fs::path& path) {
  Mat_LogInitFunc("", print_nothing);
  File file(Mat_Open(path.c_str(), MAT_ACC_RDONLY));
  if (!file) refuse_unreadable(path);
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

/// Refuses a name with several variables: libmatio takes the first one, MATLAB and SciPy the last
/// one.
void require_no_other(const fs::path& path, const std::string& name) {
  const auto count = std::ranges::count(names_in(path), name);
  if (count < 2) return;
  refuse_file(path, fmt::format("has {} variables named {}, and programs read different ones; save "
                                "it with distinct names",
                                count, name));
}

[[noreturn]] void refuse_missing_variable(const fs::path& path, const std::string& wanted) {
  const std::vector<std::string> names = names_in(path);
  if (std::ranges::find(names, wanted) != names.end()) {
    refuse_file(path, "variable " + wanted + " is damaged or truncated");
  }
  refuse_file(path, "has no variable " + wanted + "; it has " + listed(names));
}

template <class T>
std::vector<double> converted(const matvar_t& variable, std::size_t count) {
  if (variable.nbytes / sizeof(T) < count) return {};
  const auto* first = static_cast<const T*>(variable.data);
  return {first, first + count};
}

/// Returns the numbers; empty if there are fewer than `count`.
std::vector<double> numbers_of(const matvar_t& variable, std::size_t count) {
  if (variable.data == nullptr) return {};
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      return converted<double>(variable, count);
    case MAT_C_SINGLE:
      return converted<float>(variable, count);
    case MAT_C_INT8:
      return converted<std::int8_t>(variable, count);
    case MAT_C_UINT8:
      return converted<std::uint8_t>(variable, count);
    case MAT_C_INT16:
      return converted<std::int16_t>(variable, count);
    case MAT_C_UINT16:
      return converted<std::uint16_t>(variable, count);
    case MAT_C_INT32:
      return converted<std::int32_t>(variable, count);
    case MAT_C_UINT32:
      return converted<std::uint32_t>(variable, count);
    case MAT_C_INT64:
      return converted<std::int64_t>(variable, count);
    default:
      return converted<std::uint64_t>(variable, count);
  }
}

/// A variable of a version 5 file, or a part of one.
class Mat5Node : public Node {
 public:
  Mat5Node(const fs::path& file, std::shared_ptr<matvar_t> variable)
      : file_(file), variable_(std::move(variable)) {}

  [[nodiscard]] Kind kind() const override {
    const matio_classes type = variable_->class_type;
    if (type >= MAT_C_DOUBLE && type <= MAT_C_UINT64) {
      return variable_->isComplex != 0 ? Kind::other : Kind::numbers;
    }
    if (type == MAT_C_EMPTY) return Kind::numbers;
    if (type == MAT_C_CHAR) return Kind::text;
    if (type == MAT_C_STRUCT) return Kind::structure;
    return type == MAT_C_CELL ? Kind::cell : Kind::other;
  }

  [[nodiscard]] std::string what() const override {
    if (variable_->class_type == MAT_C_SPARSE) return "a sparse matrix; export full(...) of it";
    if (variable_->class_type == MAT_C_FUNCTION) return "a function";
    if (variable_->isComplex != 0) return "an array of complex numbers; export real(...) of it";
    return what_objects_are;
  }

  [[nodiscard]] Shape shape() const override {
    return {variable_->dims, variable_->dims + variable_->rank};
  }

  [[nodiscard]] std::vector<std::string> fields() const override {
    char* const* const names = Mat_VarGetStructFieldnames(variable_.get());
    if (names == nullptr) return {};
    return {names, names + Mat_VarGetNumberOfFields(variable_.get())};
  }

  [[nodiscard]] std::unique_ptr<Node> field(const std::string& name,
                                            std::size_t element) const override {
    return part(Mat_VarGetStructFieldByName(variable_.get(), name.c_str(), element));
  }
  [[nodiscard]] std::unique_ptr<Node> element(std::size_t element) const override {
    return part(Mat_VarGetCell(variable_.get(), static_cast<int>(element)));
  }

  [[nodiscard]] std::string text() const override {
    if (variable_->data == nullptr) return "";
    const std::size_t size = Mat_SizeOf(variable_->data_type);
    const auto* const bytes = static_cast<const char*>(variable_->data);
    std::string text;
    for (std::size_t i = 0; size > 0 && i + size <= variable_->nbytes; i += size) text += bytes[i];
    return text;
  }

  [[nodiscard]] std::vector<double> numbers() const override {
    const std::size_t count = count_of(shape());
    std::vector<double> numbers = numbers_of(*variable_, count);
    if (numbers.size() < count) refuse_file(file_, "a variable is damaged or truncated");
    return numbers;
  }
  [[nodiscard]] bool is_column_major() const override { return true; }

 private:
  /// Returns a part, which shares ownership of the whole variable.
  std::unique_ptr<Node> part(matvar_t* variable) const {
    if (variable == nullptr) return nullptr;
    return std::make_unique<Mat5Node>(file_, std::shared_ptr<matvar_t>(variable_, variable));
  }

  const fs::path& file_;
  std::shared_ptr<matvar_t> variable_;
};

bool has_parts(const matvar_t& variable) {
  return variable.class_type == MAT_C_STRUCT || variable.class_type == MAT_C_CELL;
}

std::vector<double> read_v5(const fs::path& path, std::span<const std::byte> bytes,
                            const VariablePath& wanted) {
  const std::string& name = wanted.steps.front().name;
  const File file = open(path);
  Variable variable(Mat_VarReadInfo(file.get(), name.c_str()));
  if (!variable) {
    require_intact(path, bytes);
    refuse_missing_variable(path, name);
  }
  const bool is_array =
      variable->class_type >= MAT_C_DOUBLE && variable->class_type <= MAT_C_UINT64;
  if (is_array) {
    (void)possible_count({.file = path, .noun = "variable", .name = name},
                         {variable->dims, variable->dims + variable->rank});
  }
  require_intact(path, bytes);
  require_no_other(path, name);
  if (has_parts(*variable)) {
    variable.reset(Mat_VarRead(file.get(), name.c_str()));
    if (!variable) refuse_missing_variable(path, name);
  } else if (is_array && Mat_VarReadDataAll(file.get(), variable.get()) != 0) {
    refuse_missing_variable(path, name);
  }
  const std::shared_ptr<matvar_t> whole(std::move(variable));
  return vector_at(path, std::make_unique<Mat5Node>(path, whole), wanted);
}

}  // namespace

std::vector<double> read_mat(const fs::path& path, const std::string& name) {
  const Bytes bytes = artefact::read_file(path);
  if (readable_version(path, bytes) == MAT_FT_MAT73) return read_mat73(path, name);
  const auto wanted = parse_variable(name);
  if (!wanted) {
    refuse_file(path, "has no variable " + name + "; it has " + listed(names_in(path)) +
                          hint_at_parts(name));
  }
  return read_v5(path, bytes, *wanted);
}

}  // namespace piae::raw
