#include "artefact/structure.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/one_line.hpp"

namespace piae::artefact {

namespace {

using hdf5::check;
using hdf5::Handle;

/// Far more than any stage writes. Without a limit, a file of a few kB could keep its reader busy
/// for minutes.
constexpr std::size_t most_objects = 100'000;
constexpr int deepest = 16;

[[noreturn]] void refuse(const std::string& what, const std::string& path) {
  throw std::runtime_error(what + " at " + path + ": not something this pipeline writes");
}

struct Link {
  std::string name;
  H5L_type_t type;
};

/// True if a name is a single component of a path and can be shown in a line.
bool is_plain(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos &&
         !has_control_characters(name);
}

std::string child_of(const std::string& path, const std::string& name) {
  return (path == "/" ? path : path + "/") + name;
}

bool is_string(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
}

template <hdf5::Number T>
bool is(hid_t type) {
  return H5Tequal(type, hdf5::stored_type<T>()) > 0;
}

bool is_number(hid_t type) {
  return is<float>(type) || is<double>(type) || is<std::int32_t>(type) || is<std::int64_t>(type);
}

std::vector<Link> links_of(hid_t group, const std::string& path) {
  std::vector<Link> links;
  const auto note = [](hid_t, const char* name, const H5L_info_t* info, void* out) -> herr_t {
    auto& all = *static_cast<std::vector<Link>*>(out);
    all.push_back({name, info->type});
    return all.size() > most_objects ? -1 : 0;
  };
  hsize_t from = 0;
  check(H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &from, note, &links), path.c_str());
  return links;
}

class Walk {
 public:
  explicit Walk(std::size_t size) : size_(size), left_(size) {}

  void visit(hid_t object, const std::string& path, int depth) {
    H5O_info_t info;
    // Counting the bytes of metadata also reads blocks that no value needs, such as the free list
    // of an attribute heap, and so verifies their checksums.
    check(H5Oget_info2(object, &info, H5O_INFO_ALL), path.c_str());
    note(info, path, depth);
    if (info.num_attrs > 0) visit_attributes(object, path);
    if (info.type == H5O_TYPE_DATASET) return visit_dataset(object, path);
    if (info.type != H5O_TYPE_GROUP) {
      refuse("an object that is neither a group nor a dataset", path);
    }
    for (const auto& [name, type] : links_of(object, path)) {
      if (!is_plain(name)) refuse("a link with a name that no file should have", path);
      const std::string child = child_of(path, name);
      if (type == H5L_TYPE_SOFT) refuse("a soft link", child);
      if (type == H5L_TYPE_EXTERNAL) refuse("a link to another file", child);
      if (type != H5L_TYPE_HARD) refuse("a link of an unknown kind", child);
      visit(Handle(H5Oopen(object, name.c_str(), H5P_DEFAULT), child.c_str()), child, depth + 1);
      paths_.push_back(child);
    }
  }

  /// Returns the paths of all objects but the root, in alphabetical order.
  std::vector<std::string> paths() && {
    std::ranges::sort(paths_);
    return std::move(paths_);
  }

 private:
  void note(const H5O_info_t& info, const std::string& path, int depth) {
    if (depth > deepest) refuse("a group too deep", path);
    // A forged link count can be wrong, so addresses are compared, too.
    const bool is_new = addresses_.insert(info.addr).second;
    if (!is_new || (depth > 0 && info.rc > 1)) refuse("a second link to one object", path);
    if (addresses_.size() > most_objects) refuse("more objects than any stage writes", path);
  }

  void visit_attributes(hid_t object, const std::string& path) {
    for (const std::string& name : hdf5::attribute_names(object)) {
      std::string where = path;
      where.append(", attribute ").append(name);
      if (!is_plain(name)) refuse("an attribute with a name that no file should have", path);
      const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), where.c_str());
      const Handle type(H5Aget_type(attribute), where.c_str());
      if (!hdf5::holds_one_value(attribute)) refuse("an array of values", where);
      take(type, 1, where);
    }
  }

  void visit_dataset(hid_t dataset, const std::string& path) {
    const Handle type(H5Dget_type(dataset), path.c_str());
    const Handle space(H5Dget_space(dataset), path.c_str());
    if (H5Sget_simple_extent_type(space) != H5S_SIMPLE) refuse("a dataset without a shape", path);
    const hdf5::Shape shape = hdf5::shape_of(dataset);
    require_our_layout(dataset, shape, path);
    const bool is_empty = std::ranges::find(shape, std::size_t{0}) != shape.end();
    std::size_t count = is_empty ? 0 : 1;
    for (const std::size_t n : shape) {
      if (n > size_ || (count > 0 && n > left_ / count)) refuse_size(path);
      count *= n;
    }
    take(type, count, path);
  }

  /// Requires the layout that Writer uses: one piece, not compressed, not in other files.
  static void require_our_layout(hid_t dataset, const hdf5::Shape& shape, const std::string& path) {
    const Handle creation(H5Dget_create_plist(dataset), path.c_str());
    const H5D_layout_t layout = H5Pget_layout(creation);
    if (layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) refuse("a dataset of this layout", path);
    if (H5Pget_external_count(creation) != 0) refuse("a dataset that is kept in other files", path);
    const int filters = H5Pget_nfilters(creation);
    check(filters, path.c_str());
    for (int i = 0; i < filters; ++i) {
      unsigned flags = 0;
      std::size_t values = 0;
      const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags,
                                                 &values, nullptr, 0, nullptr, nullptr);
      if (filter != H5Z_FILTER_FLETCHER32) refuse("a dataset that is compressed or filtered", path);
    }
    if (layout == H5D_CHUNKED) require_one_chunk(creation, shape, path);
  }

  static void require_one_chunk(hid_t creation, const hdf5::Shape& shape, const std::string& path) {
    std::vector<hsize_t> chunk(shape.size());
    check(H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), path.c_str());
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (chunk[i] != std::max<hsize_t>(shape[i], 1)) refuse("a dataset in several chunks", path);
    }
  }

  /// Counts the bytes of one dataset or attribute. All values together must fit into the file.
  void take(hid_t type, std::size_t count, const std::string& where) {
    if (H5Tcommitted(type) > 0) refuse("a named type", where);
    if (!is_number(type) && !is_string(type)) refuse("values of this type", where);
    const std::size_t size = H5Tget_size(type);
    if (size == 0) refuse("a type without a size", where);
    if (count > 0 && size > left_ / count) refuse_size(where);
    left_ -= size * count;
  }

  [[noreturn]] static void refuse_size(const std::string& where) {
    throw std::runtime_error(where + " claims more bytes than the file has");
  }

  std::set<haddr_t> addresses_;
  std::vector<std::string> paths_;
  std::size_t size_;
  std::size_t left_;  ///< bytes of the file that no value has claimed
};

}  // namespace

std::vector<std::string> require_our_structure(hid_t file, std::size_t size) {
  const Handle root(H5Gopen2(file, "/", H5P_DEFAULT), "/");
  Walk walk(size);
  walk.visit(root, "/", 0);
  return std::move(walk).paths();
}

}  // namespace piae::artefact
