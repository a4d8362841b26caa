#include "artefact/hdf5.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "artefact/fletcher32.hpp"

static_assert(std::endian::native == std::endian::little, "values are stored as they are");

namespace piae::artefact::hdf5 {

namespace {

// HDF5 would print its errors. Here the exception carries the reason instead.
[[maybe_unused]] const bool quiet = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;

herr_t keep_deepest(unsigned /*depth*/, const H5E_error2_t* error, void* reason) {
  if (error->desc != nullptr && *error->desc != '\0') {
    *static_cast<std::string*>(reason) = error->desc;
  }
  return 0;
}

std::string reason_from_hdf5() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_deepest, &reason);
  H5Eclear2(H5E_DEFAULT);
  return reason.empty() ? "unknown HDF5 error" : reason;
}

Handle property_list(hid_t type) { return {H5Pcreate(type), "property list"}; }

/// Makes the groups that lead to `path`. HDF5 would add timestamps to them.
void make_parents(hid_t file, const std::string& path) {
  const Handle creation = property_list(H5P_GROUP_CREATE);
  check(H5Pset_obj_track_times(creation, 0), path.c_str());
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos;
       slash = path.find('/', slash + 1)) {
    const std::string group = path.substr(0, slash);
    if (H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0) continue;
    const Handle made(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT),
                      group.c_str());
  }
}

Handle fixed_string_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), "string type");
  check(H5Tset_size(type, std::max<std::size_t>(length, 1)), "string type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "string type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "string type");
  return type;
}

/// Growth of a file in memory, in bytes.
constexpr std::size_t growth = 4096;

/// Offset of the end address in a superblock of HDF5 1.8 and later. Memory beyond that address is
/// spare and is not written to the disk, so that every byte on the disk belongs to the file and a
/// lost byte is noticed.
constexpr std::size_t end_address_at = 28;

/// Keeps the bytes of a file in memory, which HDF5 would free when it closes the file.
struct ImageKeeper {
  bool wanted = false;  ///< true during MemoryFile::close()
  Bytes image;
};

thread_local ImageKeeper keeper;

void* allocate_image(size_t size, H5FD_file_image_op_t, void*) { return std::malloc(size); }

void* copy_image(void* to, const void* from, size_t size, H5FD_file_image_op_t, void*) {
  return std::memcpy(to, from, size);
}

void* reallocate_image(void* image, size_t size, H5FD_file_image_op_t, void*) {
  void* const larger = std::realloc(image, size);
  if (larger != nullptr) expect_much(larger, size);
  return larger;
}

herr_t release_image(void* image, H5FD_file_image_op_t operation, void*) {
  if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE && keeper.wanted) {
    const auto* bytes = static_cast<const std::byte*>(image);
    std::uint64_t end = 0;
    std::memcpy(&end, bytes + end_address_at, sizeof end);
    keeper.image = Bytes(image, end);
  } else {
    std::free(image);
  }
  return 0;
}

/// Avoids a copy for reading: every request of HDF5 for memory gets the image itself.
void* given_image(size_t, H5FD_file_image_op_t, void* image) { return image; }

void* image_in_place(void* to, const void*, size_t, H5FD_file_image_op_t, void*) { return to; }

herr_t leave_image(void*, H5FD_file_image_op_t, void*) { return 0; }

void* same_keeper(void* udata) { return udata; }

herr_t no_keeper_to_free(void*) { return 0; }

std::vector<hsize_t> extent(const Shape& shape) { return {shape.begin(), shape.end()}; }

std::size_t stored_bytes(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), "dataset");
  std::size_t size = H5Tget_size(type);
  for (const std::size_t n : shape_of(dataset)) size *= n;
  return size;
}

/// Writes all values of a dataset as its single chunk. HDF5 would copy them twice more, and compute
/// the checksum word by word.
void write_chunk(hid_t dataset, std::span<const std::byte> values, const std::string& path) {
  const std::uint32_t checksum = fletcher32(values);
  Bytes chunk(values.size() + sizeof checksum);
  std::ranges::copy(values, chunk.begin());
  std::memcpy(chunk.begin() + values.size(), &checksum, sizeof checksum);
  const std::vector<hsize_t> first(shape_of(dataset).size());
  check(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, first.data(), chunk.size(), chunk.data()),
        path.c_str());
}

/// Returns a name that is unique in this process. HDF5 treats two files in memory with the same
/// name as one file, and reads the first. A file on the disk cannot have this name either, which
/// matters because HDF5 looks in the working folder.
std::string new_name() {
  static std::atomic<std::uint64_t> count = 0;
  return "/dev/null/artefact-" + std::to_string(++count);
}

}  // namespace

void make_group(hid_t file, const std::string& path) { make_parents(file, path + "/"); }

hid_t check(hid_t result, const char* what) {
  if (result < 0) throw std::runtime_error(std::string(what) + ": " + reason_from_hdf5());
  return result;
}

MemoryFile::MemoryFile() : access_(property_list(H5P_FILE_ACCESS)) {
  H5FD_file_image_callbacks_t callbacks{allocate_image, copy_image,  reallocate_image,
                                        release_image,  same_keeper, no_keeper_to_free,
                                        &keeper};
  check(H5Pset_fapl_core(access_, growth, 0), "file in memory");
  check(H5Pset_file_image_callbacks(access_, &callbacks), "file in memory");
  check(H5Pset_libver_bounds(access_, H5F_LIBVER_V110, H5F_LIBVER_V110), "file format");
  const Handle creation = property_list(H5P_FILE_CREATE);
  check(H5Pset_obj_track_times(creation, 0), "file without timestamps");
  file_ = Handle(H5Fcreate(new_name().c_str(), H5F_ACC_TRUNC, creation, access_), "file in memory");
}

Bytes MemoryFile::close() {
  check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "flush");
  keeper.wanted = true;
  file_ = Handle();
  keeper.wanted = false;
  return std::exchange(keeper.image, {});
}

std::span<const std::byte> MemoryFile::image() const {
  // Chunks are written immediately. Flushing the rest would change its place in the file.
  void* handle = nullptr;
  check(H5Fget_vfd_handle(file_, H5P_DEFAULT, &handle), "file in memory");
  hsize_t size = 0;
  check(H5Fget_filesize(file_, &size), "file in memory");
  return {*static_cast<const std::byte* const*>(handle), size};
}

Handle open_image(std::span<const std::byte> image) {
  // HDF5 is not const-correct here; it does not write to a file that is open for reading.
  auto* const bytes = const_cast<std::byte*>(image.data());
  H5FD_file_image_callbacks_t callbacks{given_image, image_in_place,    nullptr, leave_image,
                                        same_keeper, no_keeper_to_free, bytes};
  const Handle access = property_list(H5P_FILE_ACCESS);
  check(H5Pset_fapl_core(access, growth, 0), "file in memory");
  check(H5Pset_file_image_callbacks(access, &callbacks), "file in memory");
  check(H5Pset_file_image(access, bytes, image.size()), "open");
  return {H5Fopen(new_name().c_str(), H5F_ACC_RDONLY, access), "open"};
}

void write_numbers(hid_t file, const std::string& path, hid_t type, const void* data,
                   const Shape& shape) {
  make_parents(file, path);
  const std::vector<hsize_t> dims = extent(shape);
  std::vector<hsize_t> chunk = dims;  // one chunk: artefacts are read whole
  for (hsize_t& n : chunk) n = std::max<hsize_t>(n, 1);
  const Handle creation = property_list(H5P_DATASET_CREATE);
  check(H5Pset_obj_track_times(creation, 0), path.c_str());
  check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), path.c_str());
  check(H5Pset_fletcher32(creation), path.c_str());
  const Handle space(H5Screate_simple(static_cast<int>(dims.size()), dims.data(), nullptr),
                     path.c_str());
  const Handle dataset(
      H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
      path.c_str());
  if (std::ranges::find(dims, hsize_t{0}) != dims.end()) return;
  write_chunk(dataset, {static_cast<const std::byte*>(data), stored_bytes(dataset)}, path);
}

void write_strings(hid_t file, const std::string& path, const std::vector<std::string>& strings) {
  make_parents(file, path);
  std::size_t longest = 1;
  for (const std::string& s : strings) longest = std::max(longest, s.size());
  std::string packed;
  for (const std::string& s : strings) packed += s + std::string(longest - s.size(), '\0');
  const Handle type = fixed_string_type(longest);
  const hsize_t count = strings.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), path.c_str());
  const Handle creation = property_list(H5P_DATASET_CREATE);
  check(H5Pset_obj_track_times(creation, 0), path.c_str());
  const Handle dataset(
      H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
      path.c_str());
  if (count == 0) return;
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), path.c_str());
}

Handle open_dataset(hid_t file, const std::string& path) {
  return {H5Dopen2(file, path.c_str(), H5P_DEFAULT), path.c_str()};
}

std::optional<StoredValues> stored_values(hid_t dataset, std::span<const std::byte> image) {
  const Handle creation(H5Dget_create_plist(dataset), "dataset");
  if (H5Pget_layout(creation) != H5D_CHUNKED || H5Pget_nfilters(creation) != 1) return {};
  const std::vector<hsize_t> first(shape_of(dataset).size());
  unsigned left_out_filters = 0;
  haddr_t address = HADDR_UNDEF;
  hsize_t stored = 0;
  const herr_t found =
      H5Dget_chunk_info_by_coord(dataset, first.data(), &left_out_filters, &address, &stored);
  const std::size_t size = stored_bytes(dataset);
  StoredValues there{};
  if (found < 0 || address == HADDR_UNDEF || left_out_filters != 0 || size % 2 != 0 ||
      stored != size + sizeof there.fletcher32 || address > image.size() ||
      stored > image.size() - address) {
    return {};
  }
  there.values = image.subspan(address, size);
  std::memcpy(&there.fletcher32, image.data() + address + size, sizeof there.fletcher32);
  return there;
}

Shape shape_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), "dataspace");
  const int rank = H5Sget_simple_extent_ndims(space);
  check(rank, "dataspace");
  std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space, dims.data(), nullptr), "dataspace");
  return {dims.begin(), dims.end()};
}

void read_checked(hid_t dataset, hid_t type, void* values, const std::string& path) {
  const Handle transfer = property_list(H5P_DATASET_XFER);
  check(H5Pset_edc_check(transfer, H5Z_DISABLE_EDC), path.c_str());
  check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, transfer, values), path.c_str());
}

std::vector<std::string> read_strings(hid_t file, const std::string& path) {
  const Handle dataset = open_dataset(file, path);
  const Handle type(H5Dget_type(dataset), path.c_str());
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) {
    throw std::runtime_error(path + ": is not a list of fixed-length strings");
  }
  const Shape shape = shape_of(dataset);
  const std::size_t count = shape.size() == 1 ? shape[0] : 0;
  const std::size_t length = H5Tget_size(type);
  std::string packed(count * length, '\0');
  if (count > 0) {
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), path.c_str());
  }
  std::vector<std::string> strings;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string padded = packed.substr(i * length, length);
    strings.push_back(padded.substr(0, padded.find('\0')));
  }
  return strings;
}

void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     hid_t type, const void* value) {
  const Handle object(H5Oopen(file, object_path.c_str(), H5P_DEFAULT), object_path.c_str());
  const Handle space(H5Screate(H5S_SCALAR), name.c_str());
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         name.c_str());
  check(H5Awrite(attribute, type, value), name.c_str());
}

void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     const std::string& value) {
  const Handle type = fixed_string_type(value.size());
  const std::string padded = value.empty() ? std::string(1, '\0') : value;
  write_attribute(file, object_path, name, type, padded.data());
}

bool holds_one_value(hid_t attribute) {
  const Handle space(H5Aget_space(attribute), "dataspace");
  return H5Sget_simple_extent_type(space) == H5S_SCALAR;
}

std::string read_string_attribute(hid_t file, const std::string& object_path,
                                  const std::string& name) {
  const Handle attribute(
      H5Aopen_by_name(file, object_path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
      name.c_str());
  const Handle type(H5Aget_type(attribute), name.c_str());
  if (!holds_one_value(attribute) || H5Tget_class(type) != H5T_STRING ||
      H5Tis_variable_str(type) != 0) {
    throw std::runtime_error(name + ": is not one fixed-length string");
  }
  std::string value(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, value.data()), name.c_str());
  return value.substr(0, value.find('\0'));
}

std::vector<std::string> object_paths(hid_t file) {
  std::vector<std::string> paths;
  const auto visit = [](hid_t, const char* name, const H5O_info_t*, void* out) -> herr_t {
    if (std::strcmp(name, ".") != 0) {
      static_cast<std::vector<std::string>*>(out)->push_back("/" + std::string(name));
    }
    return 0;
  };
  check(H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, visit, &paths), "list of datasets");
  std::ranges::sort(paths);
  return paths;
}

std::vector<std::string> attribute_names(hid_t object) {
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
    static_cast<std::vector<std::string>*>(out)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names), "attributes");
  std::ranges::sort(names);
  return names;
}

}  // namespace piae::artefact::hdf5
