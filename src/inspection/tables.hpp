#pragma once

#include <string>

#include "inspection/check.hpp"
#include "signal/description.hpp"

namespace piae::inspection {

/// What was found, as tables for a terminal of 100 columns: the recordings, their fault lines, and
/// the classes. Long names lose their beginning.
std::string tables_of(const signal::Description& description, const DatasetCheck& check);

/// The unit of the signals in words: "g", "mg", "m/s²", or "units" where it is another one.
std::string unit_name(double unit_m_per_s2);

}  // namespace piae::inspection
