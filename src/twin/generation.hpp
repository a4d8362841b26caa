#pragma once

#include <cstddef>

#include "artefact/reader.hpp"
#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "twin/backend.hpp"
#include "twin/variant.hpp"

namespace piae::twin {

/// Eqs 15 and 26: draws `count` points of the digital twin space for each class with a defect and
/// decodes them with the class's label. Returns the windows in the recordings' unit, each with its
/// (k, c). Window i of a class draws from the stream's child "<class>/<i>", so the first n windows
/// do not depend on `count`. Throws artefact::Refusal if the model is of another variant.
signal::WindowSet generate(const artefact::Reader& model, const TwinVariant& variant,
                           std::size_t count, const Stream& stream, const Engine& engine);

}  // namespace piae::twin
