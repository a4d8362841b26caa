#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

inline constexpr const char* lossy_sound =
    "is sound with lossy compression, which changes vibration; record WAV (PCM) or FLAC";

/// Reads a channel, counted from 1, of a WAV, RF64, W64, AIFF or FLAC file with libsndfile.
/// Integers are scaled to a full scale of 1; floats are unchanged. Throws Error(bad_input) if the
/// file is shorter than declared, contradicts itself, or is compressed with loss. Also throws if a
/// FLAC checksum, of a frame or of all samples (flac_sum.hpp), does not match.
Signal read_sound(const std::filesystem::path& file, const std::string& channel);

}  // namespace piae::raw
