#pragma once

#include "plan/plan.hpp"

namespace piae::plan {

/// Writes the files by which the steps that are to be run read their settings, each unless it holds
/// that already. Throws Error(failed) where one cannot be written, or a folder of them is a link.
void write_settings(Plan& plan);

}  // namespace piae::plan
