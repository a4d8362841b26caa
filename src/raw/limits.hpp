#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace piae::raw {

/// Largest size of a raw file in bytes. MATLAB files of version 5 end at 2 GB.
inline constexpr std::uint64_t largest_bytes = 4'000'000'000;

/// Limits for reading raw files one by one. They follow from the file sizes alone, because a
/// damaged file may declare anything.
struct Limits {
  std::uint64_t file_bytes = 0;    ///< total size of the files
  std::uint64_t most_samples = 0;  ///< most samples that the files can hold, even if compressed
  std::uint64_t memory_bytes = 0;
  std::uint64_t processor_seconds = 0;
  std::uint64_t wall_seconds = 0;  ///< allows for a busy machine or disk
};

/// Returns the limits for these files. Throws Error(input_missing) if a file is missing, and
/// Error(bad_input) if one of them, or all together, exceed largest_bytes.
Limits limits_of(const std::vector<std::filesystem::path>& files);
inline Limits limits_of(const std::filesystem::path& file) { return limits_of(std::vector{file}); }

/// Limits this process: beyond the limits, memory requests fail or the process ends.
void keep_to(const Limits& limits);

/// Makes all writes to files fail during its lifetime. Output after its lifetime may go to a file.
class WritesNoFile {
 public:
  WritesNoFile();
  WritesNoFile(const WritesNoFile&) = delete;
  WritesNoFile& operator=(const WritesNoFile&) = delete;
  ~WritesNoFile();

 private:
  std::uint64_t most_before_;  ///< previous limit in bytes
};

}  // namespace piae::raw
