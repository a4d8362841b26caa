#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace piae::raw {

/// The most bytes of a raw file. Version 5 of MATLAB's files ends at 2 GB.
inline constexpr std::uint64_t largest_bytes = 4'000'000'000;

/// Limits of what reading raw files one by one may take. All of it follows from their sizes, since
/// what a file says of itself may be wrong.
struct Limits {
  std::uint64_t file_bytes = 0;    ///< of all
  std::uint64_t most_samples = 0;  ///< that all can hold, however well they are compressed
  std::uint64_t memory_bytes = 0;
  std::uint64_t processor_seconds = 0;
  std::uint64_t wall_seconds = 0;  ///< more, as a machine or a disk may be busy
};

/// Throws Error(input_missing) for a file that is missing, and Error(bad_input) where one, or all
/// together, are larger than largest_bytes.
Limits limits_of(const std::vector<std::filesystem::path>& files);
inline Limits limits_of(const std::filesystem::path& file) { return limits_of(std::vector{file}); }

/// Has this process end, or its requests for memory fail, where it takes more.
void keep_to(const Limits& limits);

/// Lets this process write to no file as long as it lives: such a write fails. What it prints
/// afterwards may go to a file.
class WritesNoFile {
 public:
  WritesNoFile();
  WritesNoFile(const WritesNoFile&) = delete;
  WritesNoFile& operator=(const WritesNoFile&) = delete;
  ~WritesNoFile();

 private:
  std::uint64_t most_before_;  ///< bytes of a file
};

}  // namespace piae::raw
