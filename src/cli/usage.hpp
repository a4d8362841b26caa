#pragma once

#include <string>

namespace piae::cli {

/// Returns the resources used by this process so far, for the log of a step: "step: used 11.93 s of
/// processor time and 153 MB of memory". Time includes all threads and finished child programs.
/// Memory is the highest peak of any of them, in 10^6 bytes.
std::string usage_line();

}  // namespace piae::cli
