#pragma once

#include "signal/toml_table.hpp"

namespace piae::signal {

/// Reads what a description says of the stage split, in [split], if it says anything. It is that
/// stage that uses it; here it is checked. Throws Error(bad_input) with file, line and key for what
/// no option of split is, or may be, and where no fault is to be known though [transfer] says in
/// which conditions they are.
void check_described_split(TomlTable& root);

}  // namespace piae::signal
