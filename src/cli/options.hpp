#pragma once

#include <string>

#include "cli/checks.hpp"

// CLI11 does the work, but its headers cost 5 s a file: only src/cli includes them.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace piae::cli {

/// One option that was added.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required(bool is_required = true);
  /// Refuses values, each of them where the option takes several, before they are converted.
  Option& check(const Check& check);
  /// What the help calls its value.
  Option& type_name(const std::string& name);

 private:
  CLI::Option* option_;
};

/// Adds options to a program's command line, and so to its TOML file, whose keys are the names
/// without dashes. Programs hand it to whoever has options: bind(stage.options(), split_options).
class Options {
 public:
  explicit Options(CLI::App& app, std::string group = "Options");

  /// The same command line; what is added stands under this heading in the help.
  [[nodiscard]] Options in_group(const std::string& group) const;

  /// `value` is the default until the command line is parsed, and must live until then. T is int,
  /// std::int64_t, std::size_t, double, std::string, std::filesystem::path, or a vector of
  /// std::string, std::int64_t or std::filesystem::path, whose option takes any number of values.
  template <class T>
  Option add(const std::string& name, T& value, const std::string& help) const;
  /// True when it is given.
  Option flag(const std::string& name, bool& value, const std::string& help) const;

 private:
  CLI::App* app_;
  std::string group_;
};

}  // namespace piae::cli
