#include "artefact/reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "artefact/belongs_in.hpp"
#include "artefact/digest.hpp"
#include "artefact/file.hpp"
#include "artefact/rehearsal.hpp"
#include "artefact/structure.hpp"
#include "artefact/writer.hpp"
#include "base/one_line.hpp"
#include "base/sha256.hpp"

namespace piae::artefact {

namespace {

namespace fs = std::filesystem;
using hdf5::Handle;

const std::string remedy = "; rerun the stage that wrote it";

/// Copies numbers from bytes, in parts that stay in the cache: a vector zeroes its elements before
/// they are overwritten.
template <hdf5::Number T>
std::vector<T> values_in(std::span<const std::byte> bytes) {
  constexpr std::size_t at_once = 4096;
  const std::size_t count = bytes.size() / sizeof(T);
  std::vector<T> values;
  values.reserve(count);
  expect_much(values.data(), bytes.size());
  while (values.size() < count) {
    const std::size_t done = values.size();
    const std::size_t more = std::min(at_once, count - done);
    values.resize(done + more);
    std::memcpy(values.data() + done, bytes.data() + done * sizeof(T), more * sizeof(T));
  }
  return values;
}

template <hdf5::Number T>
bool are_finite(std::span<const T> values) {
  if constexpr (!std::floating_point<T>) return true;
  const auto is_finite = [](T value) { return std::isfinite(value); };
  return std::ranges::count_if(values, is_finite) == std::ssize(values);
}

Bytes bytes_of(const fs::path& path) {
  try {
    return read_file(path, largest_artefact_bytes);
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

[[noreturn]] void refuse_damaged(const fs::path& path, const std::string& what) {
  throw Refusal(Exit::bad_input, RefusalReason::damaged,
                path.string() + ": damaged: " + what + remedy);
}

void require_undamaged(const fs::path& path, hid_t file, std::span<const std::byte> image) {
  try {
    const std::vector<std::string> paths = require_our_structure(file, image.size());
    const Digests digests = digests_of(file, paths, image);
    if (digests.content != hdf5::read_string_attribute(file, "/", digest_attribute)) {
      refuse_damaged(path, "the content digest does not match");
    }
    if (digests.provenance !=
        hdf5::read_string_attribute(file, provenance_group, digest_attribute)) {
      refuse_damaged(path, "the digest of " + provenance_group + " does not match");
    }
  } catch (const Refusal&) {
    throw;
  } catch (const std::exception& error) {
    refuse_damaged(path, error.what());
  }
}

std::string stored_kind(const fs::path& path, hid_t file) {
  const htri_t exists = H5Aexists(file, "kind");
  if (exists < 0) refuse_damaged(path, "its attributes cannot be read");
  const std::string foreign =
      ": is HDF5, but not an artefact of this pipeline; name a file that one of its stages wrote";
  try {
    std::string kind = hdf5::read_string_attribute(file, "/", "kind");
    if (!has_control_characters(kind)) return kind;
  } catch (const std::exception&) {
    // not an artefact either
  }
  throw Refusal(Exit::bad_input, RefusalReason::wrong_kind, path.string() + foreign);
}

std::int64_t stored_schema(const fs::path& path, hid_t file) {
  const std::string name = "schema";
  const Handle attribute(H5Aopen(file, name.c_str(), H5P_DEFAULT), name.c_str());
  const Handle type(H5Aget_type(attribute), name.c_str());
  if (H5Tequal(type, hdf5::stored_type<std::int64_t>()) <= 0) {
    throw Refusal(Exit::bad_input, RefusalReason::wrong_kind,
                  path.string() + ": its schema version is not a whole number" + remedy);
  }
  std::int64_t schema = 0;
  hdf5::check(H5Aread(attribute, type, &schema), name.c_str());
  return schema;
}

/// Checks everything that must be true of a file before its contents are used.
void require_artefact(const fs::path& path, std::span<const std::byte> image,
                      const std::string& kind) {
  const Handle file = open_checked(path, image);
  const std::string stored = stored_kind(path, file);
  require_undamaged(path, file, image);
  const std::int64_t schema = stored_schema(path, file);
  if (schema != schema_version) {
    throw Refusal(Exit::bad_input, RefusalReason::wrong_kind,
                  path.string() + ": has schema version " + std::to_string(schema) +
                      ", but this program reads " + std::to_string(schema_version) + remedy);
  }
  if (!kind.empty() && stored != kind) {
    throw Refusal(Exit::bad_input, RefusalReason::wrong_kind,
                  path.string() + ": is an artefact of kind '" + stored + "', not '" + kind + "'");
  }
}

Rehearsal rehearsal_of(const fs::path& path, std::span<const std::byte> image,
                       const std::string& kind) {
  // Starts OpenSSL here, once, instead of in each child: children are copies of this process.
  [[maybe_unused]] static const Sha256 started;
  return {.size = image.size(),
          .otherwise = path.string() + ": damaged: it cannot be read safely" + remedy,
          .read = [&path, image, &kind] { require_artefact(path, image, kind); }};
}

/// Returns the bytes of a file after a child process, which the file could harm, has found it to be
/// a whole artefact.
Bytes rehearsed(const fs::path& path, const std::string& kind) {
  Bytes image = bytes_of(path);
  const Rehearsal file = rehearsal_of(path, image, kind);
  const auto objection = rehearse(file.size, file.otherwise, file.read);
  if (objection) throw Refusal(Exit::bad_input, objection->reason, objection->line);
  return image;
}

}  // namespace

Reader::Reader(const fs::path& path, const std::string& kind)
    : Reader(path, rehearsed(path, kind)) {}

Reader::Reader(fs::path path, Bytes image)
    : path_(std::move(path)),
      image_(std::move(image)),
      file_(open_checked(path_, image_)),
      kind_(stored_kind(path_, file_)),
      digest_(text("/", digest_attribute)) {
  require_provenance();
}

Readers::Readers(std::vector<fs::path> paths, std::string kind)
    : paths_(std::move(paths)), kind_(std::move(kind)) {}

Reader Readers::next() {
  if (next_ == paths_.size()) throw std::logic_error("no file is left to be read");
  const std::size_t now = next_++;
  if (now >= first_ + checked_.size()) check_some(now);
  const fs::path& path = paths_[now];
  Checked& checked = checked_[now - first_];
  if (checked.refusal) throw Refusal(*checked.refusal);
  return {path, std::move(checked.image)};
}

void Readers::check_some(std::size_t first) {
  constexpr std::size_t most_files = 512;
  constexpr std::size_t most_bytes = 32'000'000;  // or one file of any size
  // If a process cannot be started, none of these files has been checked: keep none.
  checked_.clear();
  first_ = first;
  std::vector<Checked> some;
  std::vector<std::size_t> read;
  std::size_t bytes = 0;
  while (first + some.size() < paths_.size() && some.size() < most_files && bytes < most_bytes) {
    Checked& checked = some.emplace_back();
    try {
      checked.image = bytes_of(paths_[first + some.size() - 1]);
      bytes += checked.image.size();
      read.push_back(some.size() - 1);
    } catch (const Refusal& refusal) {
      checked.refusal = refusal;
    }
  }
  std::vector<Rehearsal> rehearsals;
  rehearsals.reserve(read.size());
  for (const std::size_t i : read) {
    rehearsals.push_back(rehearsal_of(paths_[first + i], some[i].image, kind_));
  }
  const auto objections = rehearse_all(rehearsals);
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!objections[i]) continue;
    some[read[i]].refusal = Refusal(Exit::bad_input, objections[i]->reason, objections[i]->line);
  }
  checked_ = std::move(some);
}

void Reader::require_provenance() const {
  for (const char* name : {"program", "version", "libraries", "cpu"}) {
    (void)text(provenance_group, name);
  }
  for (const char* name : {"/options", "/inputs"}) (void)strings(provenance_group + name);
}

std::string Reader::belongs_in() const { return artefact::belongs_in(file_); }

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

Handle Reader::open(const std::string& path) const {
  if (!has(path)) refuse_content(path, "is missing");
  Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), path.c_str());
  if (H5Iget_type(object) != H5I_DATASET) refuse_content(path, "is not a dataset");
  return object;
}

template <hdf5::Number T>
Array<T> Reader::numbers(const std::string& path, const hdf5::Shape& shape) const {
  const Handle dataset = open(path);
  const Handle type(H5Dget_type(dataset), path.c_str());
  if (H5Tequal(type, hdf5::stored_type<T>()) <= 0)
    refuse_content(path, "has the wrong type of number");
  Array<T> array{{}, hdf5::shape_of(dataset)};
  bool fits = array.shape.size() == shape.size();
  std::size_t count = 1;
  for (std::size_t i = 0; fits && i < shape.size(); ++i) {
    fits = shape[i] == 0 || shape[i] == array.shape[i];
    count *= array.shape[i];
  }
  if (!fits) refuse_content(path, "has the wrong shape");
  if (const auto stored = hdf5::stored_values(dataset, image_)) {
    array.values = values_in<T>(stored->values);
  } else if (count > 0) {
    array.values.resize(count);
    hdf5::read_checked(dataset, hdf5::stored_type<T>(), array.values.data(), path);
  }
  if (!are_finite<T>(array.values)) refuse_content(path, "holds a NaN or an infinite value");
  return array;
}

template Array<float> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<double> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<std::int32_t> Reader::numbers(const std::string&, const hdf5::Shape&) const;
template Array<std::int64_t> Reader::numbers(const std::string&, const hdf5::Shape&) const;

std::vector<std::string> Reader::strings(const std::string& path) const {
  (void)open(path);
  try {
    return hdf5::read_strings(file_, path);
  } catch (const std::exception& error) {
    refuse_content(path, error.what());
  }
}

template <hdf5::Number T>
T Reader::scalar(const std::string& object, const std::string& name, const Range& range) const {
  const std::string where = object + ", attribute " + name;
  if (!has_attribute(object, name)) refuse_content(where, "is missing");
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "attribute");
  const Handle type(H5Aget_type(attribute), "attribute");
  if (H5Tequal(type, hdf5::stored_type<T>()) <= 0 || !hdf5::holds_one_value(attribute)) {
    refuse_content(where, "has the wrong type");
  }
  T value{};
  hdf5::check(H5Aread(attribute, type, &value), where.c_str());
  if (!range.holds(static_cast<double>(value))) {
    std::ostringstream is;
    is << "is " << value << ", " << range.rule();
    refuse_content(where, is.str());
  }
  return value;
}

void Reader::require_finite() const {
  for (const std::string& path : hdf5::object_paths(file_)) {
    const Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), path.c_str());
    if (H5Iget_type(object) != H5I_DATASET) continue;
    const hdf5::Shape any(hdf5::shape_of(object).size(), 0);
    const Handle type(H5Dget_type(object), path.c_str());
    // reading refuses values that are not finite
    if (H5Tequal(type, hdf5::stored_type<float>()) > 0) (void)numbers<float>(path, any);
    if (H5Tequal(type, hdf5::stored_type<double>()) > 0) (void)numbers<double>(path, any);
  }
}

double Reader::real(const std::string& object, const std::string& name, const Range& range) const {
  return scalar<double>(object, name, range);
}

std::int64_t Reader::integer(const std::string& object, const std::string& name,
                             const Range& range) const {
  return scalar<std::int64_t>(object, name, range);
}

std::string Reader::text(const std::string& object, const std::string& name) const {
  const std::string where = object + ", attribute " + name;
  if (!has_attribute(object, name)) refuse_content(where, "is missing");
  std::string value;
  try {
    value = hdf5::read_string_attribute(file_, object, name);
  } catch (const std::exception& error) {
    refuse_content(object, error.what());
  }
  if (has_control_characters(value)) refuse_content(where, "holds a control character");
  return value;
}

void Reader::require_all(const std::string& path, std::span<const double> values,
                         const Range& range) const {
  const auto bad = std::ranges::find_if(values, [&](double x) { return !range.holds(x); });
  if (bad == values.end()) return;
  std::ostringstream is;
  is << "holds " << *bad << ", " << range.rule();
  refuse_content(path, is.str());
}

void Reader::require_all(const std::string& path, std::span<const std::int64_t> values,
                         const Range& range) const {
  const std::vector<double> same(values.begin(), values.end());
  require_all(path, same, range);
}

void Reader::refuse_content(const std::string& where, const std::string& what) const {
  refuse(where, what + remedy);
}

void Reader::refuse(const std::string& where, const std::string& what) const {
  throw Refusal(Exit::bad_input, RefusalReason::bad_content,
                path_.string() + ": " + where + " " + what);
}

}  // namespace piae::artefact
