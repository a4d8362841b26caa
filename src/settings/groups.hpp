#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "report/transfer.hpp"

namespace piae::settings {

/// A group of data sets that `make transfer` averages over: a table of [transfer].
struct Group {
  std::string name;                   ///< "speeds"
  std::vector<std::string> datasets;  ///< some may lack a description, see require_datasets()
  report::GroupChoices choices;
};
/// Returns the groups of a protocol that was checked by require_groups().
std::vector<Group> groups(const toml::table& protocol);

/// Refuses, as read_protocol() does, anything in [transfer] that is not a valid group: a nested
/// table, an unknown key, a list that is missing, empty or has a repeated word, an unknown method
/// or classifier, a method with two inputs, and a name that cannot be part of a file name.
void require_groups(const std::filesystem::path& file, const toml::table& protocol);

/// Throws Error(bad_input), with the line of protocol.toml, for a data set of a group that has no
/// description. Called only when the group is requested, so that everything else still runs after a
/// description was removed.
void require_datasets(const toml::table& protocol, const std::string& group,
                      const std::filesystem::path& pipeline);

}  // namespace piae::settings
