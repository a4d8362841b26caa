#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace piae::signal {

/// True if the name is a pattern for files: `*` matches any number of characters, `?` one. Neither
/// matches a slash or the dot of a hidden file.
bool is_pattern(std::string_view name);

/// True if a path matches a pattern, folder by folder. A bracket has no special meaning.
bool matches(const std::string& pattern, const std::string& path);

/// Orders names as people count: "acc_2.csv" before "acc_10.csv". Consecutive digits are one
/// number.
bool naturally_less(std::string_view left, std::string_view right);

/// Returns the files of a record, relative to `folder`. Plain names stay, even if the file is
/// missing. Patterns are replaced by the regular files that match, in the order of
/// naturally_less(), or by nothing.
std::vector<std::string> files_of(const std::vector<std::string>& names,
                                  const std::filesystem::path& folder);

}  // namespace piae::signal
