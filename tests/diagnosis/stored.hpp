#pragma once

#include <string>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "support/folder.hpp"

namespace piae::diagnosis {

/// Stores what was written and opens it for reading.
inline artefact::Reader stored(artefact::Writer& writer, const Folder& folder,
                               const std::string& name = "stored.h5") {
  writer.save(folder / name, {"test", "", {}});
  return {folder / name, ""};
}

}  // namespace piae::diagnosis
