#pragma once

#include <string>

namespace piae::plan {

/// Names the first key in which two descriptions of a data set differ, in the order of their names,
/// with its values: "simulation.noise is 0.2, was 0.1", "record 3: file is not set, was 'a.mat'",
/// "record has 5 entries, had 4". Empty where they differ in no key, or one is no TOML.
std::string changed_key(const std::string& was, const std::string& is);

}  // namespace piae::plan
