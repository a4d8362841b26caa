#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// Reads every setting of the experiment that is not chosen on the command line: one table for each
/// stage; [train.METHOD] overrides [train] for one method. Refuses unknown tables and keys: a stage
/// would ignore a mistyped table and run with its program's defaults.
///
/// Throws Error(bad_input), with the file and the line, for invalid TOML, a key outside all tables,
/// an unknown table, a `like` that names no table, a point of a sweep that the method's options
/// reject, an unknown classifier, and a group of data sets with an unknown method or classifier.
/// Throws Error(input_missing) if the file does not exist.
toml::table read_protocol(const std::filesystem::path& file);

/// Returns the interpretations that `make readings` tries. Each is one setting of the paper's
/// method, or several joined by +, such as "batches=class+space=class", that differ from
/// base_of_readings().
std::vector<std::string> readings(const toml::table& protocol);
std::vector<std::string> base_of_readings(const toml::table& protocol);

}  // namespace piae::settings
