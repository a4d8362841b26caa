#pragma once

#include <set>
#include <string>

namespace piae::signal {

/// Says how the key of a description that `given` seems to stand for is written: "shaft_speed_rpm
/// is meant, 60 times as much" for shaft_speed_hz, "variable is meant" for column. The key is one
/// of `known`. Empty where none is near: another unit of the same quantity, another word for it, or
/// a letter or two that differ.
std::string meant_key(const std::string& given, const std::set<std::string>& known);

/// Says which defect a word seems to stand for: "roller" for "ball". Empty where none is.
std::string meant_defect(const std::string& given);

}  // namespace piae::signal
