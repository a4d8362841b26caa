#pragma once

#include <functional>
#include <map>
#include <string>

#include "cli/options.hpp"

namespace piae::cli {

/// Returns the error of a program with these options for one option and its value; empty if there
/// is none. Problems that only the running program can find are not reported.
std::string refusal_of(const std::function<void(const Options&)>& bind, const std::string& name,
                       const std::string& value);

/// Returns the bound options, without dashes, and their defaults as provenance records them.
std::map<std::string, std::string> defaults_of(const std::function<void(const Options&)>& bind);

}  // namespace piae::cli
