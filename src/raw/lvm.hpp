#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads a channel of a LabVIEW measurement file (.lvm) by its number, counted from 1, or its name.
/// Columns of times (X_Value) do not count as channels. Delta_X gives the sample rate. Throws
/// Error(bad_input) with the line if a value is missing. Also throws if the file has fewer values
/// than it declares. Refuses several segments with a header each, because time may be missing
/// between them.
Signal read_lvm(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
