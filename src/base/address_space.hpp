#pragma once

#include <unistd.h>

#include <cstddef>
#include <fstream>

namespace piae {

/// The bytes of address space that this process has already, on top of which a limit allows more.
inline std::size_t mapped_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace piae
