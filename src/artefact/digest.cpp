#include "artefact/digest.hpp"

#include <functional>
#include <memory>
#include <stdexcept>

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

/// Each field ends in a zero byte, so that different lists of fields never give the same bytes.
void add_field(Sha256& sha, const std::string& field) {
  sha.update(field).update(std::string_view("\0", 1));
}

void add_values(Sha256& sha, hid_t type, hid_t space,
                const std::function<void(std::byte*)>& read_into) {
  if (H5Tis_variable_str(type) > 0) throw std::runtime_error("variable-length strings");
  add_field(sha, type_name(type));
  std::vector<hsize_t> dims(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  check(H5Sget_simple_extent_dims(space, dims.data(), nullptr), "dataspace");
  for (const hsize_t n : dims) add_field(sha, std::to_string(n));
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  const std::size_t size = count * H5Tget_size(type);
  const auto bytes = std::make_unique_for_overwrite<std::byte[]>(size);
  if (size > 0) read_into(bytes.get());
  sha.update({bytes.get(), size});
}

void add_attributes(Sha256& sha, hid_t object) {
  for (const std::string& name : hdf5::attribute_names(object)) {
    if (name == digest_attribute) continue;
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), name.c_str());
    const Handle type(H5Aget_type(attribute), name.c_str());
    const Handle space(H5Aget_space(attribute), name.c_str());
    add_field(sha, "attribute " + name);
    add_values(sha, type, space, [&](std::byte* out) {
      check(H5Aread(attribute, type, out), ("attribute " + name).c_str());
    });
  }
}

void add_object(Sha256& sha, hid_t file, const std::string& path) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  add_field(sha, path);
  if (H5Iget_type(object) == H5I_DATASET) {
    const Handle type(H5Dget_type(object), path.c_str());
    const Handle space(H5Dget_space(object), path.c_str());
    add_values(sha, type, space, [&](std::byte* out) {
      check(H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out), path.c_str());
    });
  }
  add_attributes(sha, object);
}

bool is_provenance(const std::string& path) {
  return path == provenance_group || path.starts_with(provenance_group + "/");
}

std::string digest_of(hid_t file, bool provenance) {
  Sha256 sha;
  if (!provenance) add_object(sha, file, "/");
  for (const std::string& path : hdf5::object_paths(file)) {
    if (is_provenance(path) == provenance) add_object(sha, file, path);
  }
  return sha.finish_hex();
}

}  // namespace

std::string content_digest(hid_t file) { return digest_of(file, false); }

std::string provenance_digest(hid_t file) { return digest_of(file, true); }

}  // namespace piae::artefact
