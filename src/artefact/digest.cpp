#include "artefact/digest.hpp"

#include <functional>
#include <stdexcept>
#include <vector>

#include "artefact/fletcher32.hpp"
#include "base/bytes.hpp"
#include "base/sha256.hpp"

namespace piae::artefact {

namespace {

using hdf5::check;
using hdf5::Handle;

std::string type_name(hid_t type) {
  return std::to_string(H5Tget_class(type)) + ":" + std::to_string(H5Tget_size(type)) + ":" +
         std::to_string(H5Tget_order(type)) + ":" +
         (H5Tget_class(type) == H5T_INTEGER ? std::to_string(H5Tget_sign(type)) : "-");
}

/// A zero byte ends each field, so that different lists of fields never give the same bytes.
void add_field(Sha256& sha, const std::string& field) {
  sha.update(field).update(std::string_view("\0", 1));
}

void add_type(Sha256& sha, hid_t type, hid_t space) {
  if (H5Tis_variable_str(type) > 0) throw std::runtime_error("variable-length strings");
  add_field(sha, type_name(type));
  std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  check(H5Sget_simple_extent_dims(space, dims.data(), nullptr), "dataspace");
  for (const hsize_t n : dims) add_field(sha, std::to_string(n));
}

void add_values(Sha256& sha, hid_t type, hid_t space,
                const std::function<void(std::byte*)>& read_into) {
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  Bytes bytes(count * H5Tget_size(type));
  if (bytes.size() > 0) read_into(bytes.data());
  sha.update(bytes);
}

void add_attributes(Sha256& sha, hid_t object) {
  for (const std::string& name : hdf5::attribute_names(object)) {
    if (name == digest_attribute) continue;
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), name.c_str());
    const Handle type(H5Aget_type(attribute), name.c_str());
    const Handle space(H5Aget_space(attribute), name.c_str());
    add_field(sha, "attribute " + name);
    add_type(sha, type, space);
    add_values(sha, type, space, [&](std::byte* out) {
      check(H5Aread(attribute, type, out), ("attribute " + name).c_str());
    });
  }
}

void add_checked(Sha256& sha, const hdf5::StoredValues& stored, const std::string& path) {
  if (fletcher32(stored.values) != stored.fletcher32) {
    throw std::runtime_error(path + ": its checksum does not match");
  }
  sha.update(stored.values);
}

void add_dataset(Sha256& sha, hid_t dataset, std::span<const std::byte> image,
                 const std::string& path) {
  const Handle type(H5Dget_type(dataset), path.c_str());
  const Handle space(H5Dget_space(dataset), path.c_str());
  add_type(sha, type, space);
  if (const auto stored = hdf5::stored_values(dataset, image)) {
    return add_checked(sha, *stored, path);
  }
  add_values(sha, type, space, [&](std::byte* out) {
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out), path.c_str());
  });
}

void add_object(Sha256& sha, hid_t file, std::span<const std::byte> image,
                const std::string& path) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  add_field(sha, path);
  if (H5Iget_type(object) == H5I_DATASET) add_dataset(sha, object, image, path);
  add_attributes(sha, object);
}

bool is_provenance(const std::string& path) {
  return path == provenance_group || path.starts_with(provenance_group + "/");
}

}  // namespace

Digests digests_of(hid_t file, const std::vector<std::string>& paths,
                   std::span<const std::byte> image) {
  Sha256 content;
  Sha256 provenance;
  add_object(content, file, image, "/");
  for (const std::string& path : paths) {
    add_object(is_provenance(path) ? provenance : content, file, image, path);
  }
  return {.content = content.finish_hex(), .provenance = provenance.finish_hex()};
}

}  // namespace piae::artefact
