#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// Returns a sound file of one channel with 32-bit floats (format 3 of WAVE): the windows one after
/// another, not scaled. A marker at the first sample of each window gives its class and its index
/// in the artefact ("IR007 12"). The rate is rounded to whole Hz, because the format allows no
/// others. Throws Error(usage) for data that is too large for the format.
std::string wav(const Exported& exported);

}  // namespace piae::formats
