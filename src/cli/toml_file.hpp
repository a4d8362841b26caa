#pragma once

#include <toml++/toml.h>

#include <filesystem>

namespace piae::cli {

/// A TOML file as a whole, each node with the file's name as source().path. Throws Error(bad_input)
/// with the file, the line and what is wrong there; Error(input_missing) when there is no such
/// file.
toml::table parse_toml_file(const std::filesystem::path& file);

}  // namespace piae::cli
