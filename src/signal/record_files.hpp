#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace piae::signal {

/// True of a name that stands for every file that matches it: `*` is any number of characters and
/// `?` is one, neither a slash, and neither the dot that hides a file.
bool is_pattern(std::string_view name);

/// True if a path matches a pattern, folder by folder. A bracket in the pattern is a bracket.
bool matches(const std::string& pattern, const std::string& path);

/// Orders names as people count: "acc_2.csv" before "acc_10.csv". Digits that stand together are
/// one number.
bool naturally_less(std::string_view left, std::string_view right);

/// Gives the files of a record, relative to `folder`: each name as it is, whether or not there is
/// such a file, and in the place of each pattern the regular files that match it, in the order of
/// naturally_less(); none where none does.
std::vector<std::string> files_of(const std::vector<std::string>& names,
                                  const std::filesystem::path& folder);

}  // namespace piae::signal
