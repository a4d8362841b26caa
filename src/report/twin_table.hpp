#pragma once

#include <vector>

#include "report/document.hpp"
#include "run/grid.hpp"
#include "run/held.hpp"
#include "run/layout.hpp"

namespace piae::report {

/// Returns how the trainings of the twins ended, for all methods with a physics-informed module
/// whose models the run holds: losses, weights of eq. 23, their distance from the stationary point,
/// and known windows whose contact is open at rest. Returns no section if the run has no models, as
/// in a copied run. Throws artefact::Refusal for a damaged model.
std::vector<Section> twin_sections(const run::Layout& layout, const run::Grid& grid,
                                   const run::Held& held);

}  // namespace piae::report
