#pragma once

// CLI11 costs 5 s a file, so headers only name it: a .cpp that binds options includes
// <CLI/CLI.hpp>.
namespace CLI {
class App;
class Validator;
}  // namespace CLI
