#pragma once

#include <string>

#include "formats/exported.hpp"

namespace piae::formats {

/// A sound file of one channel with 32-bit floats (format 3 of WAVE): the windows one after another
/// as they are stored, not scaled, each with a marker at its first sample that says its class and
/// where it stands in the artefact ("IR007 12"). The rate is rounded to whole Hz, as the format has
/// no others. Throws Error(usage) for what is too large for the format.
std::string wav(const Exported& exported);

}  // namespace piae::formats
