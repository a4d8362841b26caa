#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// Every setting of the experiment that is not a choice of the command line: a table for each
/// stage, [train.METHOD] on top of [train] for one method. A stage would not notice a table whose
/// name is mistyped and would run with what its program has built in, so anything else is refused.
///
/// Throws Error(bad_input) with the file and the line for what is not TOML, for a key outside all
/// tables, for a table that nothing reads, for one that is like none, for points of a sweep that
/// the method's options do not take, for a classifier where there is none of that name, and for a
/// group of data sets with a method or classifier that there is not;
/// Error(input_missing) when there is no such file.
toml::table read_protocol(const std::filesystem::path& file);

/// What `make readings` tries: each is one setting of the paper's method, or several joined by +,
/// such as "batches=class+space=class", that differ from base_of_readings().
std::vector<std::string> readings(const toml::table& protocol);
std::vector<std::string> base_of_readings(const toml::table& protocol);

}  // namespace piae::settings
