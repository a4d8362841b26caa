#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace piae::cli {

/// Returns the options that `program` reads from a TOML file, flat: key = value.
///
/// If a file has tables, such as pipeline/protocol.toml, a program reads its own table, [train],
/// overridden by the table of the chosen variant, [train.piae-dt]. If the file lacks that table,
/// the program reads the top level, so a file for one program does not need tables. A variant that
/// is `like` another, like = "piae-dt", overrides the other's table.
///
/// `variant` may be empty or have no table. Throws Error(usage) if `like` does not name a table, or
/// names one that is itself `like` another.
toml::table options_of(const toml::table& file, const std::string& program,
                       const std::string& variant);

/// Returns the values of an option in a TOML file, as a command line would give them: one, or those
/// of a list.
std::vector<std::string> values_of(const toml::node& node);

}  // namespace piae::cli
