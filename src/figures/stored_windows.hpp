#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "figures/source.hpp"
#include "signal/roles.hpp"
#include "signal/window_set.hpp"

namespace piae::figures {

/// The windows of a file. Throws artefact::Refusal where they have another role, or hold what that
/// role may not.
signal::WindowSet read_windows(const std::filesystem::path& file, signal::Role role);

/// The same. Throws Error(bad_input), too, where they are not of the dataset of `real`, which is D.
signal::WindowSet read_windows_beside(const signal::WindowSet& real,
                                      const std::filesystem::path& file, signal::Role role);

/// The windows that a method generated (E), of the shown seed; nothing where the run has none and
/// needs none.
std::optional<signal::WindowSet> read_generated(const Source& source, const std::string& method,
                                                const signal::WindowSet& real);

}  // namespace piae::figures
