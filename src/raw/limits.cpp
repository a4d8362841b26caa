#include "raw/limits.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <system_error>

#include "base/address_space.hpp"
#include "base/error.hpp"
#include "raw/file.hpp"

namespace piae::raw {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t mb = 1'000'000;

/// Returns the most bytes that a file's samples need in double precision. A byte may be a whole
/// sample, which becomes 8 bytes; the factor of 16 also allows for compression of real vibration.
/// Small files, such as a sine, may be compressed better.
std::uint64_t most_sample_bytes(std::uint64_t file_bytes) {
  return std::max({16 * file_bytes, std::min(64 * file_bytes, 128 * mb), mb});
}

void limit(int resource, std::uint64_t most, std::uint64_t beyond = 0) {
  const rlimit value{most, most + beyond};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &value);
}

/// Limits the size of files that this process writes; returns the previous limit.
std::uint64_t limit_files(std::uint64_t most) {
  rlimit value{};
  ::getrlimit(RLIMIT_FSIZE, &value);
  const std::uint64_t before = value.rlim_cur;
  value.rlim_cur = most;
  ::setrlimit(RLIMIT_FSIZE, &value);
  return before;
}

}  // namespace

Limits limits_of(const std::vector<fs::path>& files) {
  Limits limits;
  for (const fs::path& file : files) {
    std::error_code missing;
    const std::uint64_t bytes = fs::file_size(file, missing);
    if (missing) throw Error(Exit::input_missing, file.string() + ": " + missing.message());
    limits.file_bytes += bytes;
    if (limits.file_bytes > largest_bytes) {
      refuse_file(file, std::string(files.size() > 1 ? "and the files before it are" : "is") +
                            " larger than " + std::to_string(largest_bytes / mb) +
                            " MB; split it into several records");
    }
    const std::uint64_t samples = most_sample_bytes(bytes);
    limits.most_samples += samples / sizeof(double);
    // Memory for the file, a library's copies of it, and the samples.
    limits.memory_bytes = std::max(limits.memory_bytes, 64 * mb + 2 * bytes + 2 * samples);
  }
  limits.processor_seconds = 5 + limits.file_bytes / (10 * mb) + files.size() / 1000;
  limits.wall_seconds = 15 + limits.file_bytes / mb + files.size() / 100;
  return limits;
}

void keep_to(const Limits& limits) {
  limit(RLIMIT_AS, mapped_bytes() + limits.memory_bytes);
  limit(RLIMIT_CPU, limits.processor_seconds, 1);  // SIGXCPU comes 1 s before SIGKILL
  limit(RLIMIT_CORE, 0);
}

WritesNoFile::WritesNoFile() : most_before_(limit_files(0)) {
  ::signal(SIGXFSZ, SIG_IGN);  // SIGXFSZ would end the process
}

WritesNoFile::~WritesNoFile() { limit_files(most_before_); }

}  // namespace piae::raw
