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
/// with the reason that HDF5 gives. Here files are in memory only. artefact/file.hpp reads them
/// from the disk and writes them to it, so that a full disk is an ordinary error and not an HDF5
/// file that cannot be closed.
namespace piae::artefact::hdf5 {

/// Returns `result`, or throws std::runtime_error("<what>: <HDF5's own reason>") when it says that
/// a call failed.
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
  // Every HDF5 call takes the bare identifier.
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)

 private:
  hid_t id_ = H5I_INVALID_HID;
};

template <class T>
concept Number = std::same_as<T, float> || std::same_as<T, double> ||
    std::same_as<T, std::int32_t> || std::same_as<T, std::int64_t>;

/// HDF5's little-endian type that stores T.
template <Number T>
hid_t stored_type() {
  if constexpr (std::same_as<T, float>) return H5T_IEEE_F32LE;
  if constexpr (std::same_as<T, double>) return H5T_IEEE_F64LE;
  if constexpr (std::same_as<T, std::int32_t>) return H5T_STD_I32LE;
  if constexpr (std::same_as<T, std::int64_t>) return H5T_STD_I64LE;
}

using Shape = std::vector<std::size_t>;

/// A new file that is built in memory, in HDF5's 1.10 format (the first with checksums on all its
/// metadata) and without timestamps.
class MemoryFile {
 public:
  MemoryFile();
  [[nodiscard]] hid_t id() const { return file_; }
  /// Closes the file and returns the bytes that it has on the disk. H5Fget_file_image is not used:
  /// until HDF5 1.14.6 it leaves a wrong checksum in the superblock of such files.
  Bytes close();
  /// The bytes of the chunks that were written, at their places, until something else is.
  [[nodiscard]] std::span<const std::byte> image() const;

 private:
  Handle access_;
  Handle file_;
};

/// Opens a file from its bytes, read-only. `image` must outlive the handle.
Handle open_image(std::span<const std::byte> image);

/// Makes a group and those above it, where they do not exist.
void make_group(hid_t file, const std::string& path);
/// Writes a dataset of numbers with a fletcher32 checksum; groups on its path are made.
void write_numbers(hid_t file, const std::string& path, hid_t type, const void* data,
                   const Shape& shape);
/// Writes a list of strings of fixed length (variable-length strings have no checksum in HDF5).
void write_strings(hid_t file, const std::string& path, const std::vector<std::string>& strings);

Handle open_dataset(hid_t file, const std::string& path);
/// Where the values of a dataset stand among the bytes of its file, if they stand there as they
/// are, in one piece with its checksum behind it: as write_numbers() leaves them. Else nothing.
struct StoredValues {
  std::span<const std::byte> values;
  std::uint32_t fletcher32;
};
std::optional<StoredValues> stored_values(hid_t dataset, std::span<const std::byte> image);
Shape shape_of(hid_t dataset);
/// Reads all values of a dataset without computing its checksum. For a file whose digest has been
/// found good, which says more.
void read_checked(hid_t dataset, hid_t type, void* values, const std::string& path);
std::vector<std::string> read_strings(hid_t file, const std::string& path);

/// Attributes of the object at `object_path` ("/" for the file).
void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     hid_t type, const void* value);
void write_attribute(hid_t file, const std::string& object_path, const std::string& name,
                     const std::string& value);
/// Whether an attribute is a single value: one that is read into a single variable must be.
bool holds_one_value(hid_t attribute);
std::string read_string_attribute(hid_t file, const std::string& object_path,
                                  const std::string& name);

/// Names of all datasets and groups, in alphabetical order of their paths, without the root.
std::vector<std::string> object_paths(hid_t file);
/// Names of an object's attributes, in alphabetical order.
std::vector<std::string> attribute_names(hid_t object);

}  // namespace piae::artefact::hdf5
