#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefact/reader.hpp"

namespace piae::verification {

/// One thing that is wrong, in one line that names the file.
struct Finding {
  artefact::Fault fault;
  std::string line;
};

/// Checks artefacts of any kinds: that each can be read, is undamaged, of a known schema, finite,
/// and holds what its kind must hold; and that the roles of every split among them (same dataset,
/// protocol and seed) share no window. Nothing when all is good.
std::vector<Finding> verify(const std::vector<std::filesystem::path>& files);

/// The exit status of `verify`: the bit-or of the faults.
int status_of(const std::vector<Finding>& findings);

}  // namespace piae::verification
