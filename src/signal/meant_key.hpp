#pragma once

#include <set>
#include <string>

namespace piae::signal {

/// Returns which key of `known` the key `given` seems to mean, in words: "shaft_speed_rpm is meant,
/// 60 times as much" for shaft_speed_hz, "variable is meant" for column. Recognises other units,
/// synonyms and one or two wrong letters. Empty if no key is near.
std::string meant_key(const std::string& given, const std::set<std::string>& known);

/// Returns the defect that a word seems to mean: "roller" for "ball". Empty if unknown.
std::string meant_defect(const std::string& given);

}  // namespace piae::signal
