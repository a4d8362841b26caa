#pragma once

#include <cstddef>

#include "signal/dataset_info.hpp"

namespace piae::diagnosis {

/// Returns the index of a type in symptoms::fault_types.
std::size_t place_among_types(signal::Defect fault_type);

/// Throws Error(bad_input) if a class has a defect without a fault line, and if several classes
/// have the same fault type, because lines cannot tell them apart.
void require_fault_types(const signal::DatasetInfo& info);

}  // namespace piae::diagnosis
