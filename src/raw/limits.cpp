#include "signal/raw_limits.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <span>
#include <string>
#include <system_error>

#include "base/address_space.hpp"
#include "base/error.hpp"
#include "signal/raw_file.hpp"

namespace piae::signal {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t mb = 1'000'000;

/// Bytes of samples in double precision. One byte of a file can be a whole sample, which makes 8 of
/// it, and packing real vibration does not halve that twice more. A small file may be packed
/// better, such as one of a sine.
std::uint64_t most_sample_bytes(std::uint64_t file_bytes) {
  return std::max({16 * file_bytes, std::min(64 * file_bytes, 128 * mb), mb});
}

void limit(int resource, std::uint64_t most, std::uint64_t beyond = 0) {
  const rlimit value{most, most + beyond};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &value);
}

}  // namespace

RawLimits raw_limits(const fs::path& file) {
  std::error_code missing;
  RawLimits limits;
  limits.file_bytes = fs::file_size(file, missing);
  if (missing) throw Error(Exit::input_missing, file.string() + ": " + missing.message());
  if (limits.file_bytes > largest_raw_bytes) {
    refuse_raw_file(file, "is larger than " + std::to_string(largest_raw_bytes / mb) +
                              " MB; split it into several records");
  }
  const std::uint64_t samples = most_sample_bytes(limits.file_bytes);
  limits.most_samples = samples / sizeof(double);
  // The file, what a library makes of it, and the samples.
  limits.memory_bytes = 64 * mb + 2 * limits.file_bytes + 2 * samples;
  limits.processor_seconds = 5 + limits.file_bytes / (10 * mb);
  limits.wall_seconds = 15 + limits.file_bytes / mb;
  return limits;
}

void keep_to(const RawLimits& limits) {
  limit(RLIMIT_AS, mapped_bytes() + limits.memory_bytes);
  limit(RLIMIT_CPU, limits.processor_seconds, 1);  // a signal that says so comes first
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
}

std::size_t vector_length(const fs::path& file, const std::string& name,
                          const std::size_t* dimensions, std::size_t rank) {
  std::size_t longest = 1;
  bool is_vector = true;
  for (const std::size_t extent : std::span(dimensions, rank)) {
    if (extent == 0) return 0;
    is_vector = is_vector && (extent == 1 || longest == 1);
    longest = std::max(longest, extent);
  }
  if (!is_vector) refuse_raw_file(file, name + " is not a vector");
  const std::uint64_t most = raw_limits(file).most_samples;
  if (longest > most) {
    refuse_raw_file(file, name + " is said to have " + std::to_string(longest) +
                              " values, more than the " + std::to_string(most) +
                              " that a file of this size can hold: it is damaged");
  }
  return longest;
}

}  // namespace piae::signal
