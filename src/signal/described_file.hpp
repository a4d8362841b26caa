#pragma once

#include <string>
#include <vector>

#include "signal/toml_table.hpp"

namespace piae::signal {

/// Throws Error(bad_input) for a `file` outside the data folder, because `make data` writes
/// downloads there.
void require_file_name(const TomlTable& table, const std::string& name);

/// Reads `file`: one name or pattern, or several. Throws as require_file_name() does.
std::vector<std::string> read_file_names(TomlTable& record);

/// Reads the name of a variable of a file. Limits its length, because the name becomes an argument
/// of the program that reads the file.
std::string read_variable(TomlTable& table, const std::string& key);

}  // namespace piae::signal
