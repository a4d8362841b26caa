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

}  // namespace piae::cli
