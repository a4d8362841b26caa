#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// The group that says how an artefact was made. The content digest leaves it out.
inline const std::string provenance_group = "/provenance";

/// SHA-256 over the path, type, shape and values of every dataset and attribute of the file, in
/// alphabetical order. Provenance and the digest itself are left out. It does not depend on how
/// HDF5 arranges the file. Where `image` has the bytes of the file, values are digested there,
/// after their checksums were found right; else HDF5 reads them. Throws std::runtime_error naming
/// the dataset that cannot be read.
std::string content_digest(hid_t file, std::span<const std::byte> image = {});

/// The same over what stands in the provenance group, and nothing else.
std::string provenance_digest(hid_t file, std::span<const std::byte> image = {});

/// The name of the attribute that holds a digest. The content digest is an attribute of the root,
/// the digest of the provenance one of the group /provenance.
inline const std::string digest_attribute = "digest";

}  // namespace piae::artefact
