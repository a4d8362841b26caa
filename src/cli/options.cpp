#include "cli/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace piae::cli {

namespace {

/// The help does not show defaults of lists, and of values that are optional.
template <class T>
void leave_out_default(CLI::Option& /*option*/, const T& /*value*/) {}
template <class T>
void leave_out_default(CLI::Option& option, const std::vector<T>& /*values*/) {
  option.default_str("");
}
template <class T>
void leave_out_default(CLI::Option& option, const std::optional<T>& /*value*/) {
  option.default_str("");
}

}  // namespace

Option& Option::required(bool is_required) {
  option_->required(is_required);
  return *this;
}

Option& Option::check(const Check& check) {
  option_->check([refusal = check.refusal](const std::string& text) { return refusal(text); },
                 check.shown);
  return *this;
}

Option& Option::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Option& Option::from_environment(const std::string& variable) {
  option_->envname(variable);
  return *this;
}

Options::Options(CLI::App& app, std::string group) : app_(&app), group_(std::move(group)) {}

Options Options::in_group(const std::string& group) const { return Options(*app_, group); }

template <class T>
Option Options::add(const std::string& name, T& value, const std::string& help) const {
  CLI::Option* option = app_->add_option(name, value, help)->group(group_);
  leave_out_default(*option, value);
  return Option(option);
}

template Option Options::add(const std::string&, int&, const std::string&) const;
template Option Options::add(const std::string&, std::int64_t&, const std::string&) const;
template Option Options::add(const std::string&, std::size_t&, const std::string&) const;
template Option Options::add(const std::string&, double&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<double>&, const std::string&) const;
template Option Options::add(const std::string&, std::string&, const std::string&) const;
template Option Options::add(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::int64_t>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::filesystem::path>&,
                             const std::string&) const;

Option Options::choose_word(const std::string& name, const std::vector<std::string>& words,
                            const std::string& now, const std::function<void(std::size_t)>& take,
                            const std::string& help) const {
  const auto take_word = [words, take](const std::string& text) {
    take(static_cast<std::size_t>(std::ranges::find(words, text) - words.begin()));
  };
  CLI::Option* option = app_->add_option_function<std::string>(name, take_word, help);
  option->default_str(now)->group(group_);
  return Option(option).check(one_of(words));
}

Option Options::flag(const std::string& name, bool& value, const std::string& help) const {
  return Option(app_->add_flag(name, value, help)->group(group_));
}

}  // namespace piae::cli
