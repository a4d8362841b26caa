#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

namespace piae::page {

/// A TOML file with its comments, which parsers leave out.
class CommentedToml {
 public:
  /// Throws Error(input_missing) for a file that cannot be read, Error(bad_input) for no TOML.
  explicit CommentedToml(const std::filesystem::path& file);

  [[nodiscard]] const toml::table& values() const { return values_; }

  /// The comment behind a value of values(), and on the lines below it as far as they hold nothing
  /// but an indented comment; empty where there is none.
  [[nodiscard]] std::string comment_beside(const toml::node& node) const;

 private:
  toml::table values_;
  std::vector<std::string> lines_;
};

/// A value as a person writes it: 7.94, not 7.9400000000000004; a table as "key = value" in one
/// line.
std::string plain_value(const toml::node& node);

}  // namespace piae::page
