#pragma once

#include <string>

namespace piae::cli {

/// What this process has used until now, for the log of a step: "step: used 11.93 s of processor
/// time and 153 MB of memory". The time is that of all its threads and of the programs that it
/// has run, the memory the most that one of them held at a time, in 10^6 bytes.
std::string usage_line();

}  // namespace piae::cli
