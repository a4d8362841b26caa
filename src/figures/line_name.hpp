#pragma once

#include <string>

#include "signal/dataset_info.hpp"

namespace piae::figures {

/// What the lines of a defect in an envelope spectrum are called: "BPFO", "BPFI" or "2BSF".
std::string line_name(signal::Defect defect);

}  // namespace piae::figures
