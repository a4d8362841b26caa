#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

namespace piae::cli {

/// The options that `program` reads from a TOML file, flat: key = value.
///
/// Of a file with tables, such as pipeline/protocol.toml, a program reads its own table, [train],
/// and on top of it the table of the chosen variant, [train.piae-dt]. A file without that table is
/// read from the top, so that a file for one program alone needs none. A variant that differs
/// little from another names it, like = "piae-dt", and stands on top of its table.
///
/// `variant` may be empty, or one that has no table. Throws Error(usage) for a `like` that names no
/// table, or one that is itself like another.
toml::table options_of(const toml::table& file, const std::string& program,
                       const std::string& variant);

/// The values of an option in a TOML file, as a command line would give them: one, or those of a
/// list.
std::vector<std::string> values_of(const toml::node& node);

}  // namespace piae::cli
