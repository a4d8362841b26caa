#pragma once

#include <vector>

#include "report/document.hpp"
#include "run/grid.hpp"
#include "run/held.hpp"
#include "run/layout.hpp"

namespace piae::report {

/// How the trainings of the twins ended: losses, the weights of eq. 23 and how far these are from
/// its stationary point, and known windows whose contact is open at rest; of all methods with a
/// physics-informed module whose models the run holds. No section where it holds none, as in a
/// copied run. Throws artefact::Refusal for a damaged model.
std::vector<Section> twin_sections(const run::Layout& layout, const run::Grid& grid,
                                   const run::Held& held);

}  // namespace piae::report
