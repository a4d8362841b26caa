#pragma once

#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace piae {

/// Returns the bytes of address space that this process has mapped, to which a limit is added.
inline std::size_t mapped_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace piae
