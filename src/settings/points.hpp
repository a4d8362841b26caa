#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::settings {

/// One setting to try: an option of train, and its value.
struct Point {
  std::string factor;  ///< "batch"
  std::string value;   ///< "1"
};

/// Parses "batch=1". Returns an empty value if the word is not a point.
std::optional<Point> parse_point(const std::string& word);

/// Refuses a list with a repeated word, or with a word that is neither a point nor several points
/// of different factors joined by +.
void require_points(const std::filesystem::path& file, const toml::table& protocol,
                    const std::string& table, const std::string& list);

/// Returns the words of a list in a table, which may be nested: "sweep.smote".
std::vector<std::string> words_of(const toml::table& protocol, const std::string& table,
                                  const std::string& list);

}  // namespace piae::settings
