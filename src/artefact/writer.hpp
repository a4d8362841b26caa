#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"
#include "artefact/provenance.hpp"

namespace piae::artefact {

/// Version of the layout of all artefacts. A reader refuses any other.
inline constexpr std::int64_t schema_version = 1;

/// The most bytes of an artefact, which is read as a whole. Those of the paper's data sets have
/// some megabytes.
inline constexpr std::uint64_t largest_artefact_bytes = 4'000'000'000;

/// An artefact that was written.
struct Written {
  std::string digest;      ///< of its content
  std::string belongs_in;  ///< the name of the file that it belongs in, see belongs_in.hpp
};

/// Builds an artefact in memory. save() then writes it, complete or not at all.
///
///     Writer writer("windows");
///     writer.numbers("/windows", samples, {n, 1024});
///     writer.attribute("/", "seed", std::int64_t{3});
///     writer.save("A.h5", provenance);
class Writer {
 public:
  explicit Writer(const std::string& kind);

  /// Row-major numbers (float, double, int32 or int64). Throws std::logic_error when the number of
  /// values does not fit the shape, and Error(failed) when one of them is NaN or infinite: no
  /// stage writes such a number, whatever went wrong before it.
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

  /// Adds provenance and digests, and writes the file as write_file_atomically() does. No other
  /// call may follow.
  Written save(const std::filesystem::path& path, const Provenance& provenance);

 private:
  hdf5::MemoryFile file_;
};

}  // namespace piae::artefact
