#pragma once

#include <string>

#include "signal/dataset_info.hpp"

namespace piae::figures {

/// Returns the name of a defect's lines in an envelope spectrum: "BPFO", "BPFI" or "2BSF".
std::string line_name(signal::Defect defect);

}  // namespace piae::figures
