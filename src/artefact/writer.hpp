#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"
#include "artefact/provenance.hpp"

namespace piae::artefact {

/// Version of the layout of all artefacts. Readers refuse any other version.
inline constexpr std::int64_t schema_version = 1;

/// Largest size of an artefact in bytes. Artefacts are read whole; those of the paper's data sets
/// have some megabytes.
inline constexpr std::uint64_t largest_artefact_bytes = 4'000'000'000;

/// An artefact that was written.
struct Written {
  std::string digest;      ///< content digest
  std::string belongs_in;  ///< name of the file in a run, see belongs_in.hpp
};

/// Builds an artefact in memory. save() writes the whole file or nothing.
///
///     Writer writer("windows");
///     writer.numbers("/windows", samples, {n, 1024});
///     writer.attribute("/", "seed", std::int64_t{3});
///     writer.save("A.h5", provenance);
class Writer {
 public:
  explicit Writer(const std::string& kind);

  /// Writes row-major numbers (float, double, int32 or int64). Throws std::logic_error if the
  /// number of values differs from the shape, and Error(failed) for NaN or infinity, which a stage
  /// must never write.
  template <hdf5::Number T>
  void numbers(const std::string& path, std::span<const T> values, const hdf5::Shape& shape);
  template <hdf5::Number T>
  void numbers(const std::string& path, const std::vector<T>& values, const hdf5::Shape& shape) {
    numbers(path, std::span<const T>(values), shape);
  }
  template <hdf5::Number T>
  void numbers(const std::string& path, const std::vector<T>& values) {
    numbers(path, std::span<const T>(values), {values.size()});
  }
  void strings(const std::string& path, const std::vector<std::string>& values);
  void group(const std::string& path);

  void attribute(const std::string& object, const std::string& name, double value);
  void attribute(const std::string& object, const std::string& name, std::int64_t value);
  void attribute(const std::string& object, const std::string& name, const std::string& value);

  /// Adds provenance and digests, and writes the file as write_file_atomically() does. Must be the
  /// last call.
  Written save(const std::filesystem::path& path, const Provenance& provenance);

 private:
  hdf5::MemoryFile file_;
};

}  // namespace piae::artefact
