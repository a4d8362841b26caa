#pragma once

#include <filesystem>

#include "signal/description.hpp"
#include "signal/split.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// Reads [split] of a description: settings for the stage split. Throws Error(bad_input) with file,
/// line and key for an unknown option or value, and if no fault is known although [transfer] names
/// known conditions.
SplitSettings read_described_split(TomlTable& root);

/// Returns the options of the stage split: the built-in ones with these settings applied.
SplitOptions split_options_of(const Description& description);

/// Throws Error(bad_input) for settings that leave no window for a role; `file` is the description.
void require_sensible_split(const Description& description, const std::filesystem::path& file);

/// True unless these settings say that no fault window is known.
bool any_known(const SplitSettings& settings);

}  // namespace piae::signal
