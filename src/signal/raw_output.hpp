#pragma once

#include <filesystem>
#include <span>

namespace piae::signal {

/// Raw samples that are written one after another: float32 in the byte order of this machine,
/// without a header.
class RawOutput {
 public:
  /// A new file, or standard output for "-". Throws Error(failed) where it cannot be opened.
  explicit RawOutput(const std::filesystem::path& path);
  RawOutput(const RawOutput&) = delete;
  RawOutput& operator=(const RawOutput&) = delete;
  ~RawOutput();

  /// Throws Error(failed), as close() does.
  void write(std::span<const float> samples) const;
  void close();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace piae::signal
