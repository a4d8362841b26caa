#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// Throws Error(bad_input) with the file, the line of the node, and what is wrong there.
[[noreturn]] void refuse(const std::filesystem::path& file, const toml::node& node,
                         const std::string& what);

/// "sweep.points holds 'batch' twice".
std::string holds(const std::string& list, const std::string& word, const std::string& what);

/// The words of a list; none where there is no such list. What is no word is an empty one.
std::vector<std::string> words_in(const toml::table& table, const std::string& list);

}  // namespace piae::settings
