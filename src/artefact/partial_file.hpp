#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace piae::artefact {

/// A file beside `target` that takes its place once it is complete: "<target>.partial-" and 16
/// digits that nobody can know before, so that nobody can plant a link there. It is locked while it
/// is written: that tells it from what a killed program has left. It is removed unless it was put
/// in place. What fails says so by false, and by errno.
class PartialFile {
 public:
  explicit PartialFile(const std::filesystem::path& target);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile();

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  /// Writes the bytes, and brings them to the disk.
  [[nodiscard]] bool write(std::span<const std::byte> bytes) const;
  [[nodiscard]] bool put_in_place();

 private:
  void make();

  std::filesystem::path target_;
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Removes the partial files of `target` that killed programs have left. Those that are being
/// written stay, and so does whatever is no file of ours.
void remove_left_overs(const std::filesystem::path& target);

}  // namespace piae::artefact
