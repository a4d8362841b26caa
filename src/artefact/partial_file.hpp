#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace piae::artefact {

/// A file next to `target` that replaces it when it is complete: "<target>.partial-" and 16 random
/// digits, so that a link cannot be planted there. It is locked while it is written, which
/// distinguishes it from files of killed programs. It is removed unless it was put in place.
/// Functions return false on failure, with the reason in errno.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& target);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile();

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  /// Writes the bytes and syncs them to the disk.
  [[nodiscard]] bool write(std::span<const std::byte> bytes) const;
  [[nodiscard]] bool put_in_place();

 private:
  void make();

  std::filesystem::path target_;
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Removes the partial files of `target` that killed programs have left. Keeps files that are being
/// written, and all other files.
void remove_left_overs(const std::filesystem::path& target);

}  // namespace piae::artefact
