#include "cli/setting.hpp"

#include <CLI/CLI.hpp>
#include <vector>

namespace piae::cli {

std::string refusal_of(const std::function<void(const Options&)>& bind, const std::string& name,
                       const std::string& value) {
  CLI::App app;
  app.set_help_flag();
  bind(Options(app));
  const std::string option = "--" + name;
  if (app.get_option_no_throw(option) == nullptr) return "there is no option " + option;
  try {
    app.parse(std::vector<std::string>{option + "=" + value});
  } catch (const CLI::Error& error) {
    return error.what();
  }
  return {};
}

std::map<std::string, std::string> defaults_of(const std::function<void(const Options&)>& bind) {
  CLI::App app;
  app.set_help_flag();
  app.option_defaults()->always_capture_default();
  bind(Options(app));
  std::map<std::string, std::string> defaults;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_lnames().empty()) {
      defaults[option->get_lnames().front()] = option->get_default_str();
    }
  }
  return defaults;
}

}  // namespace piae::cli
