#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefact/reader.hpp"

namespace piae::verification {

/// One thing that is wrong, in one line that names the file.
struct Finding {
  artefact::RefusalReason reason;
  std::string line;
};

/// Checks artefacts of any kind: that each can be read, is undamaged, of a known kind and schema,
/// finite, and holds what its kind must hold; and that no window has two roles in a split. Files
/// are of one split when dataset, protocol and seed are the same. Returns nothing when all is good.
///
/// The kinds that there are stand in verify.cpp.
std::vector<Finding> verify(const std::vector<std::filesystem::path>& files);

/// The exit code of the program `verify`: the bit-or of the reasons, 0 where there is none.
int exit_code_of(const std::vector<Finding>& findings);

}  // namespace piae::verification
