#pragma once

#include <set>
#include <string>

namespace piae::signal {

/// Returns the advice to write the key of `known` that `given` seems to mean: "write
/// shaft_speed_rpm, 60 times the value" for shaft_speed_hz, "write variable" for column. Recognises
/// other units, synonyms and one or two wrong letters. Empty if no key is near.
std::string meant_key(const std::string& given, const std::set<std::string>& known);

/// Returns the defect that a word seems to mean: "roller" for "ball". Empty if unknown.
std::string meant_defect(const std::string& given);

}  // namespace piae::signal
