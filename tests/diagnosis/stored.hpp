#pragma once

#include <string>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "support/folder.hpp"

namespace piae::diagnosis {

/// What was written, as it is read again.
inline artefact::Reader stored(artefact::Writer& writer, const Folder& folder,
                               const std::string& name = "stored.h5") {
  writer.save(folder / name, {"test", "", {}});
  return {folder / name, ""};
}

}  // namespace piae::diagnosis
