#pragma once

#include <hdf5.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/bytes.hpp"

/// A thin layer over the C interface of HDF5: handles that close themselves, and calls that throw
/// with HDF5's reason. Files are in memory only. artefact/file.hpp reads and writes them, so that a
/// full disk is an ordinary error instead of an HDF5 file that cannot be closed.
namespace piae::artefact::hdf5 {

/// Returns `result`, or throws std::runtime_error("<what>: <HDF5's own reason>") if a call failed.
hid_t check(hid_t result, const char* what);

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, const char* what) : id_(check(id, what)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  // every HDF5 call takes the bare identifier
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)

 private:
  hid_t id_ = H5I_INVALID_HID;
};

template <class T>
concept Number = std::same_as<T, float> || std::same_as<T, double> ||
    std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t>;

/// Returns HDF5's little-endian type that stores T.
template <Number T>
hid_t stored_type() {
  if constexpr (std::same_as<T, float>) return H5T_IEEE_F32LE;
  if constexpr (std::same_as<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::same_as<T, std::int32_t>) return H5T_STD_I32LE;
  if constexpr (std::same_as<T, std::int64_t>) return H5T_STD_I64LE;
}

using Shape = std::vector<std::size_t>;

/// A new file in memory, in HDF5's 1.10 format (the first with checksums on all its metadata),
/// without timestamps.
class MemoryFile {
 public:
  MemoryFile();
  [[nodiscard]] hid_t id() const { return file_; }
  /// Closes the file and returns its bytes on the disk. H5Fget_file_image is not used: until HDF5
  /// 1.14.6 it leaves a wrong checksum in the superblock of such files.
  Bytes close();
  /// Returns the file with the chunks written so far; valid until the next write.
  [[nodiscard]] std::span<const std::byte> image() const;

 private:
  Handle access_;
  Handle file_;
};

/// Opens a file from its bytes, read-only. `image` must outlive the handle.
Handle open_image(std::span<const std::byte> image);

/// Makes a group and its parents, unless they exist.
void make_group(hid_t file, const std::string& path);
/// Writes a dataset of numbers with a fletcher32 checksum. Makes the groups on its path.
void write_numbers(hid_t file, const std::string& path, hid_t type, const void* data,
                   const Shape& shape);
/// Writes a list of strings of fixed length (variable-length strings have no checksum in HDF5).
void write_strings(hid_t file, const std::string& path, const std::vector<std::string>& strings);

Handle open_dataset(hid_t file, const std::string& path);
/// Values of a dataset among the bytes of its file, if they are stored as one plain piece followed
/// by its checksum, as write_numbers() does. stored_values() returns an empty value for other
/// datasets.
struct StoredValues {
  std::span<const std::byte> values;
  std::uint32_t fletcher32;
};
std::optional<StoredValues> stored_values(hid_t dataset, std::span<const std::byte> image);
Shape shape_of(hid_t dataset);
/// Reads all values of a dataset without verifying its checksum, for a file with a verified digest,
/// which is stronger.
void read_checked(hid_t dataset, hid_t type, void* values, const std::string& path);
std::vector<std::string> read_strings(hid_t file, const std::string& path);

/// Write attributes of the object at `object_path` ("/" for the file).
void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     hid_t type, const void* value);
void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     const std::string& value);
/// True if an attribute is a single value, as needed for reading it into a single variable.
bool holds_one_value(hid_t attribute);
std::string read_string_attribute(hid_t file, const std::string& object_path,
                                  const std::string& name);

/// Returns the paths of all datasets and groups except the root, in alphabetical order.
std::vector<std::string> object_paths(hid_t file);
/// Returns the names of an object's attributes, in alphabetical order.
std::vector<std::string> attribute_names(hid_t object);

}  // namespace piae::artefact::hdf5
