#pragma once

#include <string>

namespace piae::cli {

/// Goes on as another program of the folder that this one is in, with the same arguments, and does
/// not come back. Throws Error(failed) when that program cannot be started.
[[noreturn]] void hand_over(const std::string& program, char** argv);

}  // namespace piae::cli
