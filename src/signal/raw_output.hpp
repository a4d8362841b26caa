#pragma once

#include <filesystem>
#include <span>

namespace piae::signal {

/// Writes raw samples: float32 in the byte order of this machine, without a header.
class RawOutput {
 public:
  /// Opens a new file, or standard output for "-". Throws Error(failed) if that fails.
  explicit RawOutput(const std::filesystem::path& path);
  RawOutput(const RawOutput&) = delete;
  RawOutput& operator=(const RawOutput&) = delete;
  ~RawOutput();

  /// Both throw Error(failed).
  void write(std::span<const float> samples) const;
  void close();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace piae::signal
