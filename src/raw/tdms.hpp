#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads a channel of NI's TDMS format: "group/channel", or its number, counted from 1 in the order
/// of the file. Applies the file's scales (linear, polynomial; tdms_scales.hpp). The property
/// wf_increment gives the sample rate. If the writer crashed, reads up to the last whole chunk.
/// Throws Error(bad_input) if the file is shorter than declared (tdms_segments.hpp) or the channel
/// does not hold real numbers.
Signal read_tdms(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
