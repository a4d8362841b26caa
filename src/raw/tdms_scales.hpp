#pragma once

#include <functional>

#include "raw/array.hpp"
#include "raw/tdms_segments.hpp"

namespace piae::raw {

/// Converts a raw value with NI's scales.
using TdmsScales = std::function<double(double)>;

/// Returns the scales of a channel from its properties NI_Scale[n]_.... Each scale takes the raw
/// value or the output of an earlier scale; the last one gives the result. Returns null if there
/// are none, or if the values are already scaled. Throws Error(bad_input) for a scale that is
/// neither linear nor polynomial.
TdmsScales tdms_scales(const Where& where, const TdmsProperties& properties);

}  // namespace piae::raw
