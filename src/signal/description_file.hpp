#pragma once

#include <toml++/toml.h>

#include <filesystem>

namespace piae::signal {

/// Returns the TOML of a description, completed by the description named in `like`:
///
///     name = "hit-sm-1200to900"
///     like = "hit-sm-speeds"     # hit-sm-speeds.toml in the same folder
///
/// Missing keys come from that file, which may have its own `like`. Tables are completed key by
/// key; lists such as [[record]] are taken whole or not at all. Removes `like` itself. Each node
/// keeps its file and line.
///
/// Also replaces `designation = "SKF 6205"` in [bearing] by the keys that ../bearings.csv, relative
/// to the description, has for it (bearing_table.hpp).
///
/// Throws Error(bad_input) for an unknown designation, a circular `like`, or a description with
/// `like` and without its own name; Error(input_missing) if a file is missing.
toml::table read_description_file(const std::filesystem::path& file);

/// Returns the place of the table of bearings for a description; the table may be missing.
std::filesystem::path bearing_table_of(const std::filesystem::path& description);

}  // namespace piae::signal
