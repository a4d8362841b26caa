#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads a channel of a LabVIEW measurement file (.lvm), by its number, counted from 1, or its
/// name. The columns of times (X_Value) do not count as channels. Its Delta_X gives the sample
/// rate. Throws Error(bad_input) with the line where a value is missing or the file has fewer than
/// it says, and for a file of several segments with a header each: time may be missing between
/// those.
Signal read_lvm(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
