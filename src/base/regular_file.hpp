#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace piae {

/// A file that is open to be read. What is none, but a folder, a device or a pipe, might never end,
/// or never begin: nobody waits for it.
class RegularFile {
 public:
  /// Throws Error(input_missing) where there is no such file, or it cannot be read or is none.
  explicit RegularFile(const std::filesystem::path& path);
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  ~RegularFile();

  /// In bytes, when it was opened.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Reads what comes next, until the buffer is full or the file ends. Returns how much it was.
  /// Throws Error(input_missing).
  [[nodiscard]] std::size_t read(std::span<std::byte> buffer) const;

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::size_t size_ = 0;
};

}  // namespace piae
