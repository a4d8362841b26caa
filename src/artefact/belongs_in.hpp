#pragma once

#include <string>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// The name of the file in a run that an artefact belongs in: that of the role of windows, "C.h5";
/// features.h5 for a diagnosis that keeps them; else that of its kind, "model.h5". `file` is an
/// artefact.
std::string belongs_in(hid_t file);

}  // namespace piae::artefact
