#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace piae {

/// A regular file, open for reading. Refuses directories, devices and pipes, because reading them
/// may block or never end.
class RegularFile {
 public:
  /// Throws Error(input_missing) if the file does not exist, cannot be read or is not a regular
  /// file.
  explicit RegularFile(const std::filesystem::path& path);
  RegularFile(const RegularFile&) = delete;
  RegularFile& operator=(const RegularFile&) = delete;
  ~RegularFile();

  /// Returns the size at opening, in bytes.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Reads until the buffer is full or the file ends. Returns the number of bytes. Throws
  /// Error(input_missing).
  [[nodiscard]] std::size_t read(std::span<std::byte> buffer) const;

 private:
  std::filesystem::path path_;
  int descriptor_;
  std::size_t size_ = 0;
};

}  // namespace piae
