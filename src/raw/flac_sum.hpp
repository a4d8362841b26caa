#pragma once

#include <sndfile.h>

#include <filesystem>

namespace piae::raw {

/// Throws Error(bad_input) if the samples of a FLAC file do not match the MD5 sum in its header.
/// Accepts a missing sum. libsndfile verifies each frame but not this sum, so a flipped bit in the
/// number of samples would shorten the recording. Leaves the file at its end.
void require_flac_sum(const std::filesystem::path& file, SNDFILE* sound, const SF_INFO& info);

}  // namespace piae::raw
