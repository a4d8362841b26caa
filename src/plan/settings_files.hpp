#pragma once

#include "plan/plan.hpp"

namespace piae::plan {

/// Writes the settings files of the steps to be run, except files that are up to date. Throws
/// Error(failed) if a file cannot be written, or its folder is a link.
void write_settings(Plan& plan);

}  // namespace piae::plan
