#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <span>

namespace piae {

/// Writes all bytes to an open file or pipe. Returns false on failure, with the reason in errno.
[[nodiscard]] inline bool write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace piae
