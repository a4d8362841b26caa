#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// Throws Error(bad_input) with the file, the line of the node, and the problem.
[[noreturn]] void refuse(const std::filesystem::path& file, const toml::node& node,
                         const std::string& what);

/// Returns a message such as "sweep.points holds 'batch' twice".
std::string holds(const std::string& list, const std::string& word, const std::string& what);

/// Returns the words of a list; empty if the list does not exist. Other values become empty words.
std::vector<std::string> words_in(const toml::table& table, const std::string& list);

}  // namespace piae::settings
