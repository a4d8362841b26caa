#pragma once

#include <string>

namespace piae::page {

/// "0.4 s", "12 s", "5.2 min", "3.1 h".
std::string duration_label(double seconds);

/// A moment in seconds since 1970 as "2025-11-22 12:46 UTC".
std::string moment_label(double seconds_since_1970);

}  // namespace piae::page
