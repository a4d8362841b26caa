#pragma once

#include <functional>
#include <map>
#include <string>

#include "cli/options.hpp"

namespace piae::cli {

/// What is wrong with one option and its value, as a program whose options are bound so would say;
/// empty where nothing is. What only the program itself finds out, it finds out later.
std::string refusal_of(const std::function<void(const Options&)>& bind, const std::string& name,
                       const std::string& value);

/// The options that are bound so, without dashes, and their defaults as provenance records them.
std::map<std::string, std::string> defaults_of(const std::function<void(const Options&)>& bind);

}  // namespace piae::cli
