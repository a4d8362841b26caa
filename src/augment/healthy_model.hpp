#pragma once

#include <optional>

#include "augment/stored_model.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// The healthy windows that a method has heard, which is all that its model stores of windows:
/// read_learned(model, Role::healthy) reads them. Throws Error(usage) where it has heard none, and
/// Error(bad_input) where they are as long as those of C are not.
const signal::WindowSet& require_heard(const std::optional<signal::WindowSet>& healthy,
                                       const signal::WindowSet& known);

}  // namespace piae::augment
