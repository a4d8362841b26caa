#pragma once

#include <toml++/toml.h>

#include <filesystem>

namespace piae::signal {

/// The TOML of a description, completed by the one that it is like:
///
///     name = "hit-sm-1200to900"
///     like = "hit-sm-speeds"     # hit-sm-speeds.toml in the same folder
///
/// Every key that is not there is taken from that file, which may itself be like another one; of
/// tables, key by key; lists such as [[record]] are taken as a whole or not at all. `like` itself
/// is gone from what is returned. Each node keeps the file and the line where it stands.
///
/// In [bearing], `designation = "SKF 6205"` is replaced in the same way by what the file
/// ../bearings.csv, seen from the description, has for it (bearing_table.hpp).
///
/// Throws Error(bad_input) for a designation that is not there, for a `like` that goes in a circle,
/// or a description that is like another and has no name of its own; Error(input_missing) where
/// there is no such file.
toml::table read_description_file(const std::filesystem::path& file);

}  // namespace piae::signal
