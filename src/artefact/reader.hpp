#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"
#include "base/error.hpp"

namespace piae::artefact {

/// Row-major numbers with their shape.
template <hdf5::Number T>
struct Array {
  std::vector<T> values;
  hdf5::Shape shape;
};

/// What can be wrong with an artefact; `verify` answers with the bit-or of these.
enum class Fault : int {
  unreadable = 1,     ///< missing, truncated, or not an HDF5 file
  damaged = 4,        ///< a checksum or digest does not match
  wrong_kind = 8,     ///< another kind of artefact, or another schema version
  bad_content = 16,   ///< NaN, an empty class, labels or shapes that cannot be
  roles_overlap = 32  ///< a window plays two roles (2 and 64 stay free: usage, and 65 upwards)
};

/// Thrown when an artefact is refused; exit() is input_missing or bad_input.
class Refusal : public Error {
 public:
  Refusal(Exit exit, Fault fault, const std::string& line) : Error(exit, line), fault_(fault) {}
  [[nodiscard]] Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

/// An artefact that was read whole, checked against its digests, and found to be of one kind.
/// Nothing of a damaged file can be read. Every error names the file and the dataset.
class Reader {
 public:
  /// Throws Refusal. An empty `kind` accepts every kind.
  Reader(const std::filesystem::path& path, const std::string& kind);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& digest() const { return digest_; }

  [[nodiscard]] bool has(const std::string& object) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  /// Names of what lies directly in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> list(const std::string& group) const;

  /// Throws Refusal when the dataset is missing, has another type or rank, or holds a NaN or an
  /// infinite value. `shape` may leave extents open with 0.
  template <hdf5::Number T>
  [[nodiscard]] Array<T> numbers(const std::string& path, const hdf5::Shape& shape) const;
  [[nodiscard]] std::vector<std::string> strings(const std::string& path) const;

  [[nodiscard]] double real(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::int64_t integer(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& object, const std::string& name) const;

  /// Throws Refusal when any dataset of the file holds a NaN or an infinite value.
  void require_finite() const;

  /// For content that only the caller can judge: throws Refusal(bad_content) naming this file.
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const;

 private:
  template <hdf5::Number T>
  [[nodiscard]] T scalar(const std::string& object, const std::string& name) const;

  std::filesystem::path path_;
  std::vector<std::byte> image_;  ///< what file_ reads from
  hdf5::Handle file_;
  std::string kind_;
  std::string digest_;
};

}  // namespace piae::artefact
