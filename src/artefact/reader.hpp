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

/// Reasons to refuse an artefact. `verify` exits with the bit-or of those that it found. 2 and 64
/// are not used: exit code 2 means a usage error, and codes from 65 on have meanings of their own.
enum class RefusalReason : int {
  unreadable = 1,     ///< missing, truncated, or not an HDF5 file
  damaged = 4,        ///< a checksum or digest does not match
  wrong_kind = 8,     ///< another kind of artefact, or another schema version
  bad_content = 16,   ///< NaN, an empty class, impossible labels or shapes
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

/// Any number except NaN and infinity.
inline constexpr Range finite{.low = std::numeric_limits<double>::lowest(),
                              .high = std::numeric_limits<double>::max()};

/// An artefact. The constructor reads the whole file and verifies structure, digests and kind, so
/// that nothing is used from a damaged file, or from a forged one that a stage could not have
/// written (structure.hpp). A child process does this first (rehearsal.hpp). Every error names the
/// file and the dataset.
class Reader {
 public:
  /// Throws Refusal. An empty `kind` accepts every kind.
  Reader(const std::filesystem::path& path, const std::string& kind);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& digest() const { return digest_; }
  /// Returns the name that the file has in a run, see belongs_in.hpp.
  [[nodiscard]] std::string belongs_in() const;

  [[nodiscard]] bool has(const std::string& object) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  /// Returns the names of the groups and datasets directly in a group, in alphabetical order.
  [[nodiscard]] std::vector<std::string> list(const std::string& group) const;

  /// Returns the numbers of a dataset. `shape` is the required one; an extent of 0 accepts any.
  /// Throws Refusal if the dataset is missing, has another type or shape, or holds NaN or infinity.
  template <hdf5::Number T>
  [[nodiscard]] Array<T> numbers(const std::string& path, const hdf5::Shape& shape) const;
  [[nodiscard]] std::vector<std::string> strings(const std::string& path) const;

  /// Return an attribute of a group or dataset; "/" is the root. Throw Refusal if it is missing,
  /// has another type, is a number out of the range, or a text with control characters.
  [[nodiscard]] double real(const std::string& object, const std::string& name,
                            const Range& range = finite) const;
  [[nodiscard]] std::int64_t integer(const std::string& object, const std::string& name,
                                     const Range& range = finite) const;
  [[nodiscard]] std::string text(const std::string& object, const std::string& name) const;

  /// Throws Refusal if a value of a dataset is out of the range.
  void require_all(const std::string& path, std::span<const double> values,
                   const Range& range) const;
  void require_all(const std::string& path, std::span<const std::int64_t> values,
                   const Range& range) const;

  /// Throws Refusal if any dataset of the file holds NaN or infinity.
  void require_finite() const;

  /// Throws Refusal(bad_content) with this file, the place and the problem, for callers that check
  /// the content.
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const;

 private:
  friend class Readers;

  /// Takes bytes that were read and checked.
  Reader(std::filesystem::path path, Bytes image);

  /// Throws Refusal if the provenance, which pages and tables show, is incomplete.
  void require_provenance() const;
  /// Throws Refusal(bad_content) with the place, the problem and the remedy, for content that no
  /// stage of this version writes.
  [[noreturn]] void refuse_content(const std::string& where, const std::string& what) const;
  /// Throws Refusal if the path is missing or not a dataset.
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

/// Reads many artefacts of one kind in turn, each as Reader's constructor does. One child process
/// checks many of them, because starting a child takes longer than checking a small file.
class Readers {
 public:
  Readers(std::vector<std::filesystem::path> paths, std::string kind);

  /// Opens the next artefact. Throws as Reader's constructor does; the next call then continues
  /// with the following file. Throws std::logic_error after the last one.
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
  std::vector<Checked> checked_;  ///< most recent batch
  std::size_t first_ = 0;         ///< index in paths_ of the first one in checked_
  std::size_t next_ = 0;          ///< index in paths_
};

}  // namespace piae::artefact
