#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "figures/source.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::figures {

/// Reads the windows of a file. Throws artefact::Refusal if they have another role, or hold data
/// that this role may not have.
signal::WindowSet read_windows(const std::filesystem::path& file, signal::Role role);

/// Reads windows as read_windows() does. Also throws Error(bad_input) unless they are of the
/// data set of `real`, which is D.
signal::WindowSet read_windows_with(const signal::WindowSet& real,
                                    const std::filesystem::path& file, signal::Role role);

/// Reads the windows that a method generated (E), of the shown seed; empty if the run neither has
/// nor needs them.
std::optional<signal::WindowSet> read_generated(const Source& source, const std::string& method,
                                                const signal::WindowSet& real);

}  // namespace piae::figures
