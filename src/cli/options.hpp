#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

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

/// A word of an option that knows only some, and what it stands for.
template <class E>
struct Word {
  const char* text;
  E value;
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
  /// One of several words, each of which stands for a value.
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
  /// True when it is given.
  Option flag(const std::string& name, bool& value, const std::string& help) const;

 private:
  Option choose_word(const std::string& name, const std::vector<std::string>& words,
                     const std::string& now, const std::function<void(std::size_t)>& take,
                     const std::string& help) const;

  CLI::App* app_;
  std::string group_;
};

}  // namespace piae::cli
