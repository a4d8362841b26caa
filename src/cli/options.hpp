#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/checks.hpp"

// Only src/cli includes the headers of CLI11, which cost 5 s of compile time in each file.
namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace piae::cli {

/// An added option, to be refined: stage.options().add(...).required().
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required(bool is_required = true);
  /// Checks the value as typed; each value of an option that takes several.
  Option& check(const Check& check);
  /// Names its value in the help.
  Option& type_name(const std::string& name);
  /// Takes the value from an environment variable if the option is not given.
  Option& from_environment(const std::string& variable);

 private:
  CLI::Option* option_;
};

/// A word that an option accepts, and the value that it stands for.
template <class E>
struct Word {
  const char* text;
  E value;
};

/// Adds options to the command line of a program. Its TOML file accepts the same options: keys are
/// the names without leading dashes. A program passes this to the bind() of each struct of options:
/// bind(stage.options(), split_options).
class Options {
 public:
  explicit Options(CLI::App& app, std::string group = "Options");

  /// Returns options of the same command line under a heading of their own in the help.
  [[nodiscard]] Options in_group(const std::string& group) const;

  /// Adds an option. `value` holds the default, and the given value after parsing; it must live
  /// until then. T is int, std::int64_t, std::size_t, double, std::optional<double>, std::string,
  /// std::filesystem::path, or a vector of std::string, std::int64_t or std::filesystem::path. An
  /// option with a vector takes any number of values.
  template <class T>
  Option add(const std::string& name, T& value, const std::string& help) const;
  /// Adds an option that accepts one of several words, each with a value. `value` holds the
  /// default, as above.
  template <class E>
  Option choose(const std::string& name, E& value, const std::vector<Word<E>>& words,
                const std::string& help) const {
    std::vector<std::string> texts;
    std::string now;
    for (const Word<E>& word : words) {
      texts.emplace_back(word.text);
      if (word.value == value) now = word.text;
    }
    const auto take = [&value, words](std::size_t i) { value = words[i].value; };
    return choose_word(name, texts, now, take, help);
  }
  /// Adds such an option if the caller keeps the values: `take` receives the index of the given
  /// word.
  Option choose_word(const std::string& name, const std::vector<std::string>& words,
                     const std::string& now, const std::function<void(std::size_t)>& take,
                     const std::string& help) const;
  /// Adds an option without a value. `value` becomes true if it is given.
  Option flag(const std::string& name, bool& value, const std::string& help) const;

 private:
  CLI::App* app_;
  std::string group_;
};

}  // namespace piae::cli
