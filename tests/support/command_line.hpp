#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "cli/options.hpp"

namespace piae::cli {

/// Gives what `bind` binds the values of a command line, as a stage does. Throws Refused.
void parse(const std::string& line, const std::function<void(const Options&)>& bind);

/// A command line that a stage would not take.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace piae::cli
