#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace piae::settings {

/// One setting that is tried: an option of train, and its value.
struct Point {
  std::string factor;  ///< "batch"
  std::string value;   ///< "1"
};

/// "batch=1"; nothing where the word is none.
std::optional<Point> parse_point(const std::string& word);

/// Refuses a list in which a word is no point, nor several of different factors that are joined by
/// +, or is there twice.
void require_points(const std::filesystem::path& file, const toml::table& protocol,
                    const std::string& table, const std::string& list);

/// The words of a list of a table, which may be one in another: "sweep.smote".
std::vector<std::string> words_of(const toml::table& protocol, const std::string& table,
                                  const std::string& list);

}  // namespace piae::settings
