#pragma once

#include <string>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// Returns the name that an artefact has in a run: the role of windows, "C.h5"; features.h5 for a
/// diagnosis that keeps features; else its kind, "model.h5". `file` must be an artefact.
std::string belongs_in(hid_t file);

}  // namespace piae::artefact
