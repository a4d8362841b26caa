#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// A group of data sets that `make transfer` averages over: a table of [transfer].
struct Group {
  std::string name;                   ///< "speeds"
  std::vector<std::string> datasets;  ///< not all of which need be there, see require_datasets()
  std::vector<std::string> inputs;    ///< "none=wdcnn-spectrum" (report/input_choice.hpp)
  std::vector<std::string> kind_inputs = {};  ///< the same for telling kinds; may be empty
};
std::vector<Group> groups(const toml::table& protocol);

/// Refuses, as read_protocol() does, what among the tables of [transfer] is no group: a table in
/// it, a key that nothing reads, a list that is missing, empty or names one twice, a method or a
/// classifier that there is not, a method with two inputs, and a name that cannot be part of a
/// file's.
void require_groups(const std::filesystem::path& file, const toml::table& protocol);

/// Throws Error(bad_input), with the line of protocol.toml, for a data set of a group of which
/// there is no description. It is asked when the group is wanted and not before: who takes a
/// description away can still run all else.
void require_datasets(const toml::table& protocol, const std::string& group,
                      const std::filesystem::path& pipeline);

}  // namespace piae::settings
