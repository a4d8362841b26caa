#include "artefact/writer.hpp"

#include <cmath>
#include <stdexcept>

#include "artefact/belongs_in.hpp"
#include "artefact/digest.hpp"
#include "artefact/file.hpp"
#include "base/error.hpp"

namespace piae::artefact {

namespace {

template <hdf5::Number T>
void require_finite(const std::string& path, std::span<const T> values) {
  if constexpr (std::floating_point<T>) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!std::isfinite(values[i])) {
        throw Error(Exit::failed, path + ": value " + std::to_string(i) +
                                      " is NaN or infinite; nothing was written");
      }
    }
  }
}

void write_provenance(hid_t file, const Provenance& provenance) {
  hdf5::make_group(file, provenance_group);
  const auto put = [&](const std::string& name, const std::string& value) {
    hdf5::write_attribute(file, provenance_group, name, value);
  };
  put("program", provenance.program);
  put("version", build_version());
  put("libraries", build_libraries());
  put("cpu", cpu_settings());
  hdf5::write_strings(file, provenance_group + "/options", {provenance.options});
  std::vector<std::string> inputs;
  for (const auto& input : provenance.inputs) {
    inputs.push_back(input.role + " " + input.file + " " + input.digest);
  }
  hdf5::write_strings(file, provenance_group + "/inputs", inputs);
}

}  // namespace

Writer::Writer(const std::string& kind) {
  attribute("/", "kind", kind);
  attribute("/", "schema", schema_version);
}

template <hdf5::Number T>
void Writer::numbers(const std::string& path, std::span<const T> values, const hdf5::Shape& shape) {
  std::size_t count = 1;
  for (const std::size_t n : shape) count *= n;
  if (count != values.size()) throw std::logic_error(path + ": values do not fit the shape");
  require_finite(path, values);
  hdf5::write_numbers(file_.id(), path, hdf5::stored_type<T>(), values.data(), shape);
}

template void Writer::numbers(const std::string&, std::span<const float>, const hdf5::Shape&);
template void Writer::numbers(const std::string&, std::span<const double>, const hdf5::Shape&);
template void Writer::numbers(const std::string&, std::span<const std::int32_t>,
                              const hdf5::Shape&);
template void Writer::numbers(const std::string&, std::span<const std::int64_t>,
                              const hdf5::Shape&);

void Writer::strings(const std::string& path, const std::vector<std::string>& values) {
  hdf5::write_strings(file_.id(), path, values);
}

void Writer::group(const std::string& path) { hdf5::make_group(file_.id(), path); }

void Writer::attribute(const std::string& object, const std::string& name, double value) {
  require_finite(object + ", attribute " + name, std::span<const double>(&value, 1));
  hdf5::write_attribute(file_.id(), object, name, hdf5::stored_type<double>(), &value);
}

void Writer::attribute(const std::string& object, const std::string& name, std::int64_t value) {
  hdf5::write_attribute(file_.id(), object, name, hdf5::stored_type<std::int64_t>(), &value);
}

void Writer::attribute(const std::string& object, const std::string& name,
                       const std::string& value) {
  hdf5::write_attribute(file_.id(), object, name, value);
}

Written Writer::save(const std::filesystem::path& path, const Provenance& provenance) {
  write_provenance(file_.id(), provenance);
  const Digests digests = digests_of(file_.id(), hdf5::object_paths(file_.id()), file_.image());
  hdf5::write_attribute(file_.id(), provenance_group, digest_attribute, digests.provenance);
  hdf5::write_attribute(file_.id(), "/", digest_attribute, digests.content);
  Written written{.digest = digests.content, .belongs_in = belongs_in(file_.id())};
  const auto bytes = file_.close();
  if (bytes.size() > largest_artefact_bytes) {
    throw Error(Exit::failed, path.string() + ": would be larger than " +
                                  std::to_string(largest_artefact_bytes / 1'000'000) +
                                  " MB, the limit of all stages; use fewer or shorter records");
  }
  write_file_atomically(path, bytes);
  return written;
}

}  // namespace piae::artefact
