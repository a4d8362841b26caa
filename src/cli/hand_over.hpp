#pragma once

#include <string>

namespace piae::cli {

/// Goes on as another program of the folder that this one is in, with the same arguments, and does
/// not come back. Throws Error(failed) when that program cannot be started.
[[noreturn]] void hand_over(const std::string& program, char** argv);

/// LibTorch takes long to start, so it is linked to programs of its own, built from the same
/// source: one that is without it goes on as `program`.
inline void require_libtorch([[maybe_unused]] const std::string& program,
                             [[maybe_unused]] char** argv) {
#ifndef PIAE_WITH_LIBTORCH
  hand_over(program, argv);
#endif
}

}  // namespace piae::cli
