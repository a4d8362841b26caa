#include "artefact/hdf5.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "raw/file.hpp"
#include "raw/hdf5_chunks.hpp"
#include "raw/hdf5_types.hpp"
#include "raw/node.hpp"
#include "raw/variable_path.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;
namespace hdf5 = artefact::hdf5;

/// Datasets of a file for an error message. Limited, because there may be millions, and groups may
/// form cycles.
struct Datasets {
  std::vector<std::string> names;
  std::string group = "/";  ///< current group, with a slash at its end
  int groups_above = 0;
  int looked_at = 0;
};

herr_t note_datasets(hid_t group, const char* name, const H5L_info_t* link, void* out) {
  constexpr int most = 10'000;
  constexpr int deepest = 30;
  auto& datasets = *static_cast<Datasets*>(out);
  H5O_info_t object{};
  if (++datasets.looked_at > most) return 1;
  if (link->type != H5L_TYPE_HARD) return 0;
  if (H5Oget_info_by_name(group, name, &object, H5P_DEFAULT) < 0) return -1;
  if (object.type == H5O_TYPE_DATASET) datasets.names.push_back(datasets.group + name);
  if (object.type != H5O_TYPE_GROUP || datasets.groups_above == deepest) return 0;
  const std::string above = datasets.group;
  datasets.group += std::string(name) + "/";
  ++datasets.groups_above;
  const herr_t result = H5Literate_by_name(group, name, H5_INDEX_NAME, H5_ITER_INC, nullptr,
                                           note_datasets, out, H5P_DEFAULT);
  --datasets.groups_above;
  datasets.group = above;
  return result;
}

[[noreturn]] void refuse_missing_dataset(const fs::path& path, hid_t file,
                                         const std::string& wanted) {
  Datasets datasets;
  hdf5::check(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_datasets, &datasets),
              "list of datasets");
  std::ranges::sort(datasets.names);
  refuse_file(path, "has no dataset " + wanted + "; it has " + listed(datasets.names) +
                        hint_at_parts(wanted));
}

/// Target of the links of a path.
enum class Place { here, nowhere, elsewhere, circle };

/// Follows the links of a path within the file and replaces the path by one without soft links.
Place resolve(hid_t file, std::string& path) {
  constexpr int most_links = 16;
  int links = 0;
  for (std::size_t end = 0; end != std::string::npos;) {
    const std::size_t begin = end + 1;
    end = path.find('/', begin);
    const std::string part = path.substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") return Place::nowhere;
    const std::string until = path.substr(0, end);
    H5L_info_t link{};
    if (H5Lexists(file, until.c_str(), H5P_DEFAULT) <= 0) return Place::nowhere;
    hdf5::check(H5Lget_info(file, until.c_str(), &link, H5P_DEFAULT), until.c_str());
    if (link.type == H5L_TYPE_HARD) continue;
    if (link.type != H5L_TYPE_SOFT) return Place::elsewhere;
    if (++links > most_links) return Place::circle;
    std::string target(link.u.val_size, '\0');
    hdf5::check(H5Lget_val(file, until.c_str(), target.data(), target.size(), H5P_DEFAULT),
                until.c_str());
    target.resize(target.find('\0') == std::string::npos ? target.size() : target.find('\0'));
    if (!target.starts_with('/')) target.insert(0, path, 0, begin);
    if (end != std::string::npos) target.append(path, end);
    path = std::move(target);
    end = 0;  // because the target may be a link
  }
  return Place::here;
}

hdf5::Handle opened_object(hid_t file, const std::string& path) {
  return {H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str()};
}

/// Returns the text of an attribute, or "" without one. Writers other than MATLAB pad it with nulls
/// or leave it out.
std::string text_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return "";
  const hdf5::Handle attribute(H5Aopen(object, name, H5P_DEFAULT), name);
  const hdf5::Handle type(H5Aget_type(attribute), name);
  if (H5Tget_class(type) != H5T_STRING || !hdf5::holds_one_value(attribute)) return "";
  if (H5Tis_variable_str(type) > 0) {
    char* value = nullptr;
    hdf5::check(H5Aread(attribute, type, &value), name);
    std::string text = value == nullptr ? "" : value;
    H5free_memory(value);
    return text;
  }
  std::string text(H5Tget_size(type), '\0');
  hdf5::check(H5Aread(attribute, type, text.data()), name);
  return text.substr(0, text.find_last_not_of(std::string_view("\0 ", 2)) + 1);
}

/// A group or dataset of an HDF5 or MATLAB 7.3 file. In MATLAB files a structure is a group. A cell
/// array, or a field of an array of structures, is a dataset of references.
class Hdf5Node : public Node {
 public:
  Hdf5Node(const fs::path& file, hdf5::Handle object, bool is_matlab)
      : file_(file), object_(std::move(object)), is_matlab_(is_matlab) {}

  [[nodiscard]] Kind kind() const override {
    const std::string of_matlab = matlab_class();
    if (is_matlab_ && H5Aexists(object_, "MATLAB_object_decode") > 0) return Kind::other;
    if (is_matlab_ && H5Aexists(object_, "MATLAB_sparse") > 0) return Kind::other;
    if (is_group()) return Kind::structure;
    if (!is_dataset()) return Kind::other;
    if (of_matlab == "char") return Kind::text;
    switch (type_class()) {
      case H5T_INTEGER:
      case H5T_FLOAT:
        return Kind::numbers;
      case H5T_STRING:
        return Kind::text;
      case H5T_REFERENCE:
        return is_matlab_ ? Kind::cell : Kind::other;
      default:
        return Kind::other;
    }
  }

  [[nodiscard]] std::string what() const override {
    if (is_matlab_ && H5Aexists(object_, "MATLAB_sparse") > 0) {
      return "a sparse matrix; export full(...) of it";
    }
    if (is_matlab_ && H5Aexists(object_, "MATLAB_object_decode") > 0) {
      return "a MATLAB " + matlab_class() + "; export its values: x = T.Var1; save('x.mat', 'x')";
    }
    const bool is_compound = is_dataset() && type_class() == H5T_COMPOUND;
    if (is_compound && is_matlab_) return "an array of complex numbers; export real(...) of it";
    if (is_compound && is_complex()) return "an array of complex numbers; write its real part";
    if (is_dataset() && type_class() == H5T_ENUM) {
      return "an array of names or booleans; write numbers";
    }
    return is_compound ? "a table of records; export one column of it as a dataset"
                       : "neither numbers nor text";
  }

  [[nodiscard]] Shape shape() const override {
    if (is_group()) {
      const std::vector<std::string> names = fields();
      if (names.empty()) return {1};
      const auto first = child(names.front());
      return first->holds_elements() ? first->shape() : Shape{1};
    }
    if (is_matlab_ && H5Aexists(object_, "MATLAB_empty") > 0) return {0};
    Shape shape = hdf5::shape_of(object_);
    if (is_matlab_) std::ranges::reverse(shape);
    return shape;
  }

  [[nodiscard]] std::vector<std::string> fields() const override {
    std::vector<std::string> names;
    const auto note = [](hid_t, const char* name, const H5L_info_t* link, void* out) -> herr_t {
      if (link->type == H5L_TYPE_HARD && name[0] != '#') {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
      }
      return 0;
    };
    hdf5::check(H5Literate(object_, H5_INDEX_NAME, H5_ITER_INC, nullptr, note, &names), "fields");
    return names;
  }

  [[nodiscard]] std::unique_ptr<Node> field(const std::string& name,
                                            std::size_t element) const override {
    auto of_all = child(name);
    return of_all->holds_elements() ? of_all->element(element) : std::move(of_all);
  }

  [[nodiscard]] std::unique_ptr<Node> element(std::size_t element) const override {
    std::vector<hobj_ref_t> references(possible_count(here("array"), shape()));
    if (element >= references.size()) return nullptr;
    hdf5::check(H5Dread(object_, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()),
                "references");
    return std::make_unique<Hdf5Node>(
        file_,
        hdf5::Handle(H5Rdereference2(object_, H5P_DEFAULT, H5R_OBJECT, &references[element]),
                     "reference"),
        is_matlab_);
  }

  [[nodiscard]] std::string text() const override {
    if (type_class() == H5T_STRING) return "";
    std::string text;
    for (const double character : numbers()) text += static_cast<char>(character);
    return text;
  }

  [[nodiscard]] std::vector<double> numbers() const override {
    const hdf5::Handle creation(H5Dget_create_plist(object_), "dataset");
    if (H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) != 0) {
      refuse(here("dataset"),
             "is virtual or external: its values are in other files or datasets; name the file "
             "that holds them, or copy them (h5py: out['x'] = file['x'][:])");
    }
    require_known_filters(creation);
    std::vector<double> numbers(possible_count(here("dataset"), shape()));
    if (!numbers.empty()) {
      require_standard_type();
      require_written(here("dataset"), object_);
      hdf5::check(
          H5Dread(object_, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
          "values");
    }
    return numbers;
  }
  [[nodiscard]] bool is_column_major() const override { return is_matlab_; }

 private:
  /// Refuses values packed by a filter that this library cannot decode.
  void require_known_filters(hid_t creation) const {
    for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
      std::size_t parameters = 0;
      unsigned flags = 0;
      unsigned config = 0;
      std::array<char, 64> name{};
      const H5Z_filter_t filter =
          H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &parameters, nullptr,
                         name.size() - 1, name.data(), &config);
      if (filter < 0 || H5Zfilter_avail(filter) > 0) continue;
      refuse(here("dataset"),
             fmt::format(
                 "is compressed by the filter {} ({}), which is not supported; write it with gzip "
                 "(h5py: create_dataset(..., compression='gzip'))",
                 filter, name.data()));
    }
  }
  /// True for h5py's compound type of complex numbers.
  [[nodiscard]] bool is_complex() const {
    const hdf5::Handle type(H5Dget_type(object_), "type");
    return H5Tget_nmembers(type) == 2 && H5Tget_member_index(type, "r") >= 0 &&
           H5Tget_member_index(type, "i") >= 0;
  }
  void require_standard_type() const {
    const hdf5::Handle type(H5Dget_type(object_), "type");
    if (is_standard_number(type)) return;
    refuse(here("dataset"),
           "has numbers of an unusual type, or is damaged; write it as floats of 32 or 64 bits");
  }
  /// Returns the node's name in the file, for errors.
  [[nodiscard]] Where here(const char* noun) const {
    const auto size =
        static_cast<std::size_t>(std::max<ssize_t>(H5Iget_name(object_, nullptr, 0), 0));
    std::string name(size + 1, '\0');
    H5Iget_name(object_, name.data(), name.size());
    name.resize(size);
    return {.file = file_, .noun = noun, .name = name};
  }
  [[nodiscard]] bool is_group() const { return H5Iget_type(object_) == H5I_GROUP; }
  [[nodiscard]] bool is_dataset() const { return H5Iget_type(object_) == H5I_DATASET; }
  [[nodiscard]] std::string matlab_class() const {
    return is_matlab_ ? text_attribute(object_, "MATLAB_class") : "";
  }
  [[nodiscard]] H5T_class_t type_class() const {
    const hdf5::Handle type(H5Dget_type(object_), "type");
    return H5Tget_class(type);
  }
  /// True for a field with one value per element of an array of structures.
  [[nodiscard]] bool holds_elements() const {
    return is_dataset() && type_class() == H5T_REFERENCE && matlab_class() != "cell";
  }
  [[nodiscard]] std::unique_ptr<Hdf5Node> child(const std::string& name) const {
    return std::make_unique<Hdf5Node>(file_, opened_object(object_, name), is_matlab_);
  }

  const fs::path& file_;
  hdf5::Handle object_;
  bool is_matlab_;
};

hdf5::Handle opened(const fs::path& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open"};
}

/// Returns the object at a path, if there is one. Throws if the path leads to another file
/// or in a circle.
std::optional<hdf5::Handle> object_at(const fs::path& path, hid_t file, std::string name) {
  const std::string written = name;
  const Place place = resolve(file, name);
  if (place == Place::elsewhere) {
    refuse_file(path, written + " is a link to another file; name that file");
  }
  if (place == Place::circle) {
    refuse_file(path, written + " leads in a circle of soft links; name the dataset itself");
  }
  if (place == Place::nowhere) return std::nullopt;
  return opened_object(file, name);
}

std::vector<double> read_dataset(const fs::path& path, const std::string& wanted) {
  const hdf5::Handle file = opened(path);
  std::string name = wanted;
  std::optional<MatrixLine> line;
  auto object = object_at(path, file, name);
  if (!object && (line = take_matrix_line(name))) object = object_at(path, file, name);
  if (!object || H5Iget_type(*object) != H5I_DATASET) refuse_missing_dataset(path, file, wanted);
  return vector_in({.file = path, .noun = "dataset", .name = name},
                   Hdf5Node(path, std::move(*object), false), line);
}

std::vector<double> read_variable(const fs::path& path, const std::string& wanted) {
  const hdf5::Handle file = opened(path);
  VariablePath steps{.steps = {{.name = wanted}}};
  auto object = object_at(path, file, "/" + wanted);
  if (!object) {
    if (const auto parsed = parse_variable(wanted)) steps = *parsed;
    object = object_at(path, file, "/" + steps.steps.front().name);
  }
  if (!object) {
    const Hdf5Node root(path, opened_object(file, "/"), true);
    const std::string& name = steps.steps.front().name;
    refuse_file(path, "has no variable " + name + "; it has " + listed(root.fields()) +
                          hint_at_parts(name));
  }
  return vector_at(path, std::make_unique<Hdf5Node>(path, std::move(*object), true), steps);
}

/// Adds the file to HDF5's errors, which do not name it.
template <class Action>
auto naming(const fs::path& file, const Action& action) {
  try {
    return action();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    refuse_file(file, std::string("truncated, damaged or not an HDF5 file (") + error.what() + ")");
  }
}

}  // namespace

std::vector<double> read_hdf5(const fs::path& file, const std::string& dataset) {
  const std::string absolute = dataset.starts_with('/') ? dataset : "/" + dataset;
  return naming(file, [&] { return read_dataset(file, absolute); });
}

std::vector<double> read_mat73(const fs::path& file, const std::string& variable) {
  return naming(file, [&] { return read_variable(file, variable); });
}

}  // namespace piae::raw
