#pragma once

#include <string>

#include "settings/points.hpp"

namespace piae::settings {

/// Returns why the training of a method refuses a setting: "smote refuses: there is no option
/// --depth"; empty if it accepts it.
std::string refusal_of(const std::string& method, const Point& point);

}  // namespace piae::settings
