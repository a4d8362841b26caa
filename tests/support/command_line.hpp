#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "cli/options.hpp"

namespace piae::cli {

/// Parses a command line into what `bind` binds, as a stage does. Throws Refused.
void parse(const std::string& line, const std::function<void(const Options&)>& bind);

/// Thrown for a command line that a stage would refuse.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace piae::cli
