#pragma once

#include <string>

#include "inspection/check.hpp"
#include "signal/description.hpp"

namespace piae::inspection {

/// Returns the results as tables for a terminal of 100 columns: recordings, their fault lines
/// (those of an unknown bearing, if none is described), and classes. Shortens long names at their
/// start.
std::string tables_of(const signal::Description& description, const DatasetCheck& check);

/// Returns the unit of the signals in words: "g", "mg", or "units" for any other.
std::string unit_name(double unit_m_per_s2);

}  // namespace piae::inspection
