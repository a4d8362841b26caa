#pragma once

#include <toml++/toml.h>

#include <filesystem>

namespace piae::cli {

/// Parses a TOML file. Each node has the name of the file as source().path. Throws Error(bad_input)
/// with the file, the line and the problem, and Error(input_missing) if the file does not exist.
toml::table parse_toml_file(const std::filesystem::path& file);

}  // namespace piae::cli
