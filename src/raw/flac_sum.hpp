#pragma once

#include <sndfile.h>

#include <filesystem>

namespace piae::raw {

/// Throws Error(bad_input) where a FLAC file has other samples than the MD5 sum in its header says;
/// its writer may have left the sum out. libsndfile verifies each frame but not this sum, so a
/// flipped bit in the number of samples would shorten the recording. Leaves the file at its end.
void require_flac_sum(const std::filesystem::path& file, SNDFILE* sound, const SF_INFO& info);

}  // namespace piae::raw
