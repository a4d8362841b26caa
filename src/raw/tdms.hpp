#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads a channel of a TDMS file of NI: "group/channel", or its number, counted from 1 in the
/// order of the file. Its own scales (linear, polynomial) are applied (tdms_scales.hpp), and its
/// property wf_increment gives the sample rate. A file whose writer crashed is read up to its last
/// whole chunk. Throws Error(bad_input) for a file that is shorter than it says
/// (tdms_segments.hpp), and for a channel that holds no real numbers.
Signal read_tdms(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
