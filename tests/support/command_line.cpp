#include "support/command_line.hpp"

#include <CLI/CLI.hpp>

namespace piae::cli {

void parse(const std::string& line, const std::function<void(const Options&)>& bind) {
  CLI::App app;
  bind(Options(app));
  try {
    app.parse(line);
  } catch (const CLI::ParseError& error) {
    throw Refused(error.what());
  }
}

}  // namespace piae::cli
