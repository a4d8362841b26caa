#pragma once

#include <string>

#include "settings/points.hpp"

namespace piae::settings {

/// Returns why the training of a method refuses a setting, such as "smote refuses: --neighbours:
/// ..."; empty if it accepts it.
std::string refusal_of(const std::string& method, const Point& point);

}  // namespace piae::settings
