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

/// An option that was added, of which more can be said: stage.options().add(...).required().
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required(bool is_required = true);
  /// Checks the value as it was typed; each of them where the option takes several.
  Option& check(const Check& check);
  /// What the help calls its value.
  Option& type_name(const std::string& name);
  /// The variable of the environment that it is taken from where it is not given.
  Option& from_environment(const std::string& variable);

 private:
  CLI::Option* option_;
};

/// One of the words that an option knows, and the value that it stands for.
template <class E>
struct Word {
  const char* text;
  E value;
};

/// Adds options to the command line of a program. The same options can be given in its TOML file,
/// where the keys are the names without the dashes in front. A program passes this to the bind()
/// of each struct of options: bind(stage.options(), split_options).
class Options {
 public:
  explicit Options(CLI::App& app, std::string group = "Options");

  /// For options of the same command line that stand under a heading of their own in the help.
  [[nodiscard]] Options in_group(const std::string& group) const;

  /// `value` holds the default, and after the command line is parsed what was given. It must live
  /// until then. T is int, std::int64_t, std::size_t, double, std::string, std::filesystem::path,
  /// or a vector of std::string, std::int64_t or std::filesystem::path; an option with a vector
  /// takes any number of values.
  template <class T>
  Option add(const std::string& name, T& value, const std::string& help) const;
  /// An option that takes one of several words, each of which stands for a value. `value` holds the
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
  /// The same for words whose values the caller has: `take` gets the place of the word that was
  /// given.
  Option choose_word(const std::string& name, const std::vector<std::string>& words,
                     const std::string& now, const std::function<void(std::size_t)>& take,
                     const std::string& help) const;
  /// An option without a value. `value` becomes true when it is given.
  Option flag(const std::string& name, bool& value, const std::string& help) const;

 private:
  CLI::App* app_;
  std::string group_;
};

}  // namespace piae::cli
