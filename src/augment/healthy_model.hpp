#pragma once

#include <optional>

#include "augment/stored_model.hpp"
#include "signal/window_set.hpp"

namespace piae::augment {

/// Returns the healthy windows that a method was given. Models of methods without known windows
/// store only these; read_learned(model, Role::healthy) reads them. Throws Error(usage) if there
/// are none, and Error(bad_input) if their length differs from that of C.
const signal::WindowSet& require_healthy(const std::optional<signal::WindowSet>& healthy,
                                         const signal::WindowSet& known);

}  // namespace piae::augment
