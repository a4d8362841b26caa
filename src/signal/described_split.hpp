#pragma once

#include <filesystem>

#include "signal/description.hpp"
#include "signal/split.hpp"
#include "signal/toml_table.hpp"

namespace piae::signal {

/// Reads what a description says of the stage split, in [split], if it says anything. Throws
/// Error(bad_input) with file, line and key for what no option of split is, or may be, and where no
/// fault is to be known though [transfer] says in which conditions they are.
SplitSettings read_described_split(TomlTable& root);

/// The options of that stage with these settings in the place of the built-in ones.
SplitOptions split_options_of(const Description& description);

/// Throws Error(bad_input) for settings that leave no window for a role; `file` is the description.
void require_sensible_split(const Description& description, const std::filesystem::path& file);

}  // namespace piae::signal
