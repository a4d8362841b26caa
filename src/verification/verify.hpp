#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefact/reader.hpp"

namespace piae::verification {

/// One problem, in one line that names the file.
struct Finding {
  artefact::RefusalReason reason;
  std::string line;
};

/// Checks artefacts of any kind: each can be read, is undamaged, finite, of a known kind and
/// schema, and holds what its kind requires; and no window has two roles in a split. Files with the
/// same dataset, protocol and seed belong to one split. Returns an empty list if everything is
/// good.
///
/// verify.cpp lists the kinds.
std::vector<Finding> verify(const std::vector<std::filesystem::path>& files);

/// Returns the exit code of the program `verify`: the bit-or of the reasons; 0 without findings.
int exit_code_of(const std::vector<Finding>& findings);

}  // namespace piae::verification
