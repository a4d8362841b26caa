#pragma once

#include <string>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// The group that says how an artefact was made. The content digest leaves it out.
inline const std::string provenance_group = "/provenance";

/// SHA-256 over the path, type, shape and values of every dataset and attribute below the root, in
/// alphabetical order, leaving out the provenance and the digest itself. It does not depend on how
/// HDF5 lays the file out. Throws std::runtime_error naming the dataset that cannot be read.
std::string content_digest(hid_t file);

/// The same over the provenance group alone.
std::string provenance_digest(hid_t file);

/// The attribute that holds each digest: on the root, and on the provenance group.
inline const std::string digest_attribute = "digest";

}  // namespace piae::artefact
