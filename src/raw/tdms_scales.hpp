#pragma once

#include <functional>

#include "raw/array.hpp"
#include "raw/tdms_segments.hpp"

namespace piae::raw {

/// Converts a raw value by NI's scales.
using TdmsScales = std::function<double(double)>;

/// The scales of a channel, which its properties NI_Scale[n]_... describe: each takes the raw value
/// or what one before it gives; the last one gives the result. Null where there are none, or the
/// values are scaled already. Throws Error(bad_input) for a scale other than linear and polynomial.
TdmsScales tdms_scales(const Where& where, const TdmsProperties& properties);

}  // namespace piae::raw
