#include "artefact/reader.hpp"

#include <algorithm>
#include <cmath>

#include "artefact/digest.hpp"
#include "artefact/file.hpp"
#include "artefact/writer.hpp"

namespace piae::artefact {

namespace {

namespace fs = std::filesystem;
using hdf5::Handle;

const std::string remedy = "; make it again with the stage that wrote it";

std::vector<std::byte> bytes_of(const fs::path& path) {
  try {
    return read_file(path);
  } catch (const Error& error) {
    throw Refusal(error.exit(), RefusalReason::unreadable, error.what());
  }
}

Handle open_checked(const fs::path& path, std::span<const std::byte> image) {
  try {
    return hdf5::open_image(image);
  } catch (const std::exception& error) {
    throw Refusal(
        Exit::bad_input, RefusalReason::unreadable,
        path.string() + ": truncated, damaged or not an HDF5 file (" + error.what() + ")" + remedy);
  }
}

void require_undamaged(const fs::path& path, hid_t file) {
  const auto refuse = [&](const std::string& what) {
    throw Refusal(Exit::bad_input, RefusalReason::damaged,
                  path.string() + ": damaged: " + what + remedy);
  };
  std::string content;
  std::string provenance;
  try {
    content = content_digest(file);
    provenance = provenance_digest(file);
    if (content == hdf5::read_string_attribute(file, "/", digest_attribute) &&
        provenance == hdf5::read_string_attribute(file, provenance_group, digest_attribute)) {
      return;
    }
  } catch (const std::exception& error) {
    refuse(error.what());
  }
  const bool content_good = content == hdf5::read_string_attribute(file, "/", digest_attribute);
  refuse(content_good ? "the digest of " + provenance_group + " does not match"
                      : "the content digest does not match");
}

std::string stored_kind(const fs::path& path, hid_t file) {
  if (H5Aexists(file, "kind") < 0) {
    throw Refusal(Exit::bad_input, RefusalReason::damaged,
                  path.string() + ": damaged: its attributes cannot be read" + remedy);
  }
  try {
    return hdf5::read_string_attribute(file, "/", "kind");
  } catch (const std::exception&) {
    throw Refusal(Exit::bad_input, RefusalReason::wrong_kind,
                  path.string() +
                      ": is HDF5, but not an artefact of this pipeline; name a file "
                      "that one of its stages wrote");
  }
}

}  // namespace

Reader::Reader(const fs::path& path, const std::string& kind)
    : path_(path),
      image_(bytes_of(path)),
      file_(open_checked(path, image_)),
      kind_(stored_kind(path, file_)) {
  require_undamaged(path_, file_);
  if (const std::int64_t schema = integer("/", "schema"); schema != schema_version) {
    throw Refusal(Exit::bad_input, RefusalReason::wrong_kind,
                  path_.string() + ": has schema version " + std::to_string(schema) +
                      ", this program reads " + std::to_string(schema_version) + remedy);
  }
  if (!kind.empty() && kind_ != kind) {
    throw Refusal(
        Exit::bad_input, RefusalReason::wrong_kind,
        path_.string() + ": is an artefact of kind '" + kind_ + "', needed is '" + kind + "'");
  }
  digest_ = text("/", digest_attribute);
}

bool Reader::has(const std::string& object) const {
  for (std::size_t slash = object.find('/', 1); slash != std::string::npos;
       slash = object.find('/', slash + 1)) {
    if (H5Lexists(file_, object.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_, object.c_str(), H5P_DEFAULT) > 0;
}

bool Reader::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Reader::list(const std::string& group) const {
  std::vector<std::string> names;
  const std::string prefix = group == "/" ? "/" : group + "/";
  for (const std::string& path : hdf5::object_paths(file_)) {
    const bool inside = path.starts_with(prefix);
    if (inside && path.find('/', prefix.size()) == std::string::npos) {
      names.push_back(path.substr(prefix.size()));
    }
  }
  return names;
}

template <hdf5::Number T>
Array<T> Reader::numbers(const std::string& path, const hdf5::Shape& shape) const {
  if (!has(path)) refuse(path, "is missing");
  const Handle dataset = hdf5::open_dataset(file_, path);
  const Handle type(H5Dget_type(dataset), path.c_str());
  if (H5Tequal(type, hdf5::stored_type<T>()) <= 0) refuse(path, "has another type of number");
  Array<T> array{{}, hdf5::shape_of(dataset)};
  bool fits = array.shape.size() == shape.size();
  std::size_t count = 1;
  for (std::size_t i = 0; fits && i < shape.size(); ++i) {
    fits = shape[i] == 0 || shape[i] == array.shape[i];
    count *= array.shape[i];
  }
  if (!fits) refuse(path, "has another shape");
  array.values.resize(count);
  if (count > 0) {
    hdf5::read_checked(dataset, hdf5::stored_type<T>(), array.values.data(), path);
  }
  if constexpr (std::floating_point<T>) {
    const auto finite = [](T value) { return std::isfinite(value); };
    if (std::ranges::count_if(array.values, finite) != std::ssize(array.values)) {
      refuse(path, "holds a NaN or an infinite value");
    }
  }
  return array;
}

template Array<float> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<double> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<std::int32_t> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<std::int64_t> Reader::numbers(const std::string&, const hdf5::Shape&) const;

std::vector<std::string> Reader::strings(const std::string& path) const {
  if (!has(path)) refuse(path, "is missing");
  try {
    return hdf5::read_strings(file_, path);
  } catch (const std::exception& error) {
    refuse(path, error.what());
  }
}

template <hdf5::Number T>
T Reader::scalar(const std::string& object, const std::string& name) const {
  const std::string where = object + ", attribute " + name;
  if (!has_attribute(object, name)) refuse(where, "is missing");
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "attribute");
  const Handle type(H5Aget_type(attribute), "attribute");
  if (H5Tequal(type, hdf5::stored_type<T>()) <= 0) refuse(where, "has another type");
  T value{};
  hdf5::check(H5Aread(attribute, type, &value), where.c_str());
  return value;
}

void Reader::require_finite() const {
  for (const std::string& path : hdf5::object_paths(file_)) {
    const Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), path.c_str());
    if (H5Iget_type(object) != H5I_DATASET) continue;
    const hdf5::Shape any(hdf5::shape_of(object).size(), 0);
    const Handle type(H5Dget_type(object), path.c_str());
    // Reading refuses what is not finite.
    if (H5Tequal(type, hdf5::stored_type<float>()) > 0) (void)numbers<float>(path, any);
    if (H5Tequal(type, hdf5::stored_type<double>()) > 0) (void)numbers<double>(path, any);
  }
}

double Reader::real(const std::string& object, const std::string& name) const {
  return scalar<double>(object, name);
}

std::int64_t Reader::integer(const std::string& object, const std::string& name) const {
  return scalar<std::int64_t>(object, name);
}

std::string Reader::text(const std::string& object, const std::string& name) const {
  if (!has_attribute(object, name)) refuse(object + ", attribute " + name, "is missing");
  try {
    return hdf5::read_string_attribute(file_, object, name);
  } catch (const std::exception& error) {
    refuse(object, error.what());
  }
}

void Reader::refuse(const std::string& where, const std::string& what) const {
  throw Refusal(Exit::bad_input, RefusalReason::bad_content,
                path_.string() + ": " + where + " " + what);
}

}  // namespace piae::artefact
