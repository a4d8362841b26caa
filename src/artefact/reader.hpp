#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"
#include "base/bytes.hpp"
#include "base/error.hpp"
#include "base/range.hpp"

namespace piae::artefact {

/// Row-major numbers with their shape.
template <hdf5::Number T>
struct Array {
  std::vector<T> values;
  hdf5::Shape shape;
};

/// Why an artefact is refused. `verify` exits with the bit-or of the reasons that it found. 2 and
/// 64 are not used, because as an exit code 2 means a usage error, and those from 65 on have
/// meanings of their own.
enum class RefusalReason : int {
  unreadable = 1,     ///< missing, truncated, or not an HDF5 file
  damaged = 4,        ///< a checksum or digest does not match
  wrong_kind = 8,     ///< another kind of artefact, or another schema version
  bad_content = 16,   ///< NaN, an empty class, labels or shapes that cannot be
  roles_overlap = 32  ///< a window has two roles of one split
};

/// Thrown when an artefact is refused; exit() is input_missing or bad_input.
class Refusal : public Error {
 public:
  Refusal(Exit exit, RefusalReason reason, const std::string& line)
      : Error(exit, line), reason_(reason) {}
  [[nodiscard]] RefusalReason reason() const { return reason_; }

 private:
  RefusalReason reason_;
};

/// Any number but NaN and the infinite ones.
inline constexpr Range finite{.low = std::numeric_limits<double>::lowest(),
                              .high = std::numeric_limits<double>::max()};

/// An artefact. The constructor reads the whole file and checks its structure, its digests and its
/// kind, so nothing of a damaged file can be read, and of a made-up one nothing that a stage could
/// not have written (structure.hpp). It does so in a process of its own first (rehearsal.hpp).
/// Every error names the file and the dataset.
class Reader {
 public:
  /// Throws Refusal. An empty `kind` accepts every kind.
  Reader(const std::filesystem::path& path, const std::string& kind);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& digest() const { return digest_; }
  /// The name of the file that it belongs in, see belongs_in.hpp.
  [[nodiscard]] std::string belongs_in() const;

  [[nodiscard]] bool has(const std::string& object) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  /// The names of the groups and datasets directly in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> list(const std::string& group) const;

  /// The numbers of a dataset. `shape` is the one that it must have; an extent of 0 stands for any.
  /// Throws Refusal when the dataset is missing, has another type or shape, or holds a NaN or an
  /// infinite value.
  template <hdf5::Number T>
  [[nodiscard]] Array<T> numbers(const std::string& path, const hdf5::Shape& shape) const;
  [[nodiscard]] std::vector<std::string> strings(const std::string& path) const;

  /// An attribute of a group or dataset; "/" is the root. Throw Refusal when it is missing, has
  /// another type, or is a number out of the range or a text with control characters.
  [[nodiscard]] double real(const std::string& object, const std::string& name,
                            const Range& range = finite) const;
  [[nodiscard]] std::int64_t integer(const std::string& object, const std::string& name,
                                     const Range& range = finite) const;
  [[nodiscard]] std::string text(const std::string& object, const std::string& name) const;

  /// Throws Refusal when one of the values of a dataset is out of the range.
  void require_all(const std::string& path, std::span<const double> values,
                   const Range& range) const;
  void require_all(const std::string& path, std::span<const std::int64_t> values,
                   const Range& range) const;

  /// Throws Refusal when any dataset of the file holds a NaN or an infinite value.
  void require_finite() const;

  /// Throws Refusal(bad_content) with this file, where and what. For the caller, who knows what the
  /// content must be.
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const;

 private:
  friend class Readers;

  /// The same for bytes that have been read and checked.
  Reader(std::filesystem::path path, Bytes image);

  /// Throws Refusal where it does not say how it was made, as every artefact does: pages and tables
  /// show it.
  void require_provenance() const;
  /// Throws Refusal for what is not there or no dataset.
  [[nodiscard]] hdf5::Handle open(const std::string& path) const;
  template <hdf5::Number T>
  [[nodiscard]] T scalar(const std::string& object, const std::string& name,
                         const Range& range) const;

  std::filesystem::path path_;
  Bytes image_;  ///< what file_ reads from
  hdf5::Handle file_;
  std::string kind_;
  std::string digest_;
};

/// Many artefacts of a kind, one after the other, each as Reader's constructor reads it. The
/// process of its own is one for many of them: to start it takes longer than to check a small file.
class Readers {
 public:
  Readers(std::vector<std::filesystem::path> paths, std::string kind);

  /// Opens the next one. Throws as Reader's constructor does, and then goes on with the one behind
  /// it; std::logic_error where none is left.
  [[nodiscard]] Reader next();

 private:
  /// A file that was read and checked: its bytes, or why it is refused.
  struct Checked {
    Bytes image = {};
    std::optional<Refusal> refusal = std::nullopt;
  };
  void check_some(std::size_t first);

  std::vector<std::filesystem::path> paths_;
  std::string kind_;
  std::vector<Checked> checked_;  ///< the last that were
  std::size_t first_ = 0;         ///< of paths_, that checked_ begins with
  std::size_t next_ = 0;          ///< of paths_
};

}  // namespace piae::artefact
