#pragma once

#include <string>

namespace piae::plan {

/// Returns the first key, in alphabetical order, in which two descriptions of a data set differ,
/// with both values: "simulation.noise is 0.2, was 0.1", "record 3: file is not set, was 'a.mat'",
/// "record has 5 entries, had 4". Returns an empty text if no key differs or one text is not TOML.
std::string changed_key(const std::string& was, const std::string& is);

}  // namespace piae::plan
