#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace piae::signal {

/// The most bytes of a raw file. Version 5 of MATLAB's files ends at 2 GB.
inline constexpr std::uint64_t largest_raw_bytes = 4'000'000'000;

/// What reading one raw file may take. All of it follows from the file's size, since what a file
/// says of itself may be wrong.
struct RawLimits {
  std::uint64_t file_bytes = 0;
  std::uint64_t most_samples = 0;  ///< that it can hold, however well it is compressed
  std::uint64_t memory_bytes = 0;
  std::uint64_t processor_seconds = 0;
  std::uint64_t wall_seconds = 0;  ///< more, as a machine or a disk may be busy
};

/// Throws Error(input_missing) where there is no such file, and Error(bad_input) where it is larger
/// than any that is read.
RawLimits raw_limits(const std::filesystem::path& file);

/// Has this process end, or its requests for memory fail, where it takes more; and lets it write no
/// file at all.
void keep_to(const RawLimits& limits);

/// The number of values in an array of these dimensions. Throws Error(bad_input) with the file and
/// the array's name where it is no vector, or has more of them than the file can hold.
std::size_t vector_length(const std::filesystem::path& file, const std::string& name,
                          const std::size_t* dimensions, std::size_t rank);

}  // namespace piae::signal
