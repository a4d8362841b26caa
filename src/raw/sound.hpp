#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads a channel, counted from 1, of a WAV, RF64, W64, AIFF or FLAC file, by libsndfile. The full
/// scale of whole numbers is 1; floats are as they stand. Throws Error(bad_input) where the file is
/// shorter than it says, or a checksum of FLAC does not match, that of a frame or of all samples
/// (flac_sum.hpp).
Signal read_sound(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
