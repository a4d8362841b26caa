#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// The group that says how an artefact was made. The content digest leaves it out.
inline const std::string provenance_group = "/provenance";

struct Digests {
  /// Of everything but the provenance and the digests themselves.
  std::string content;
  /// Of what stands in the provenance group, and nothing else.
  std::string provenance;
};

/// SHA-256 over the path, type, shape and values of every dataset and attribute of the file, in
/// alphabetical order. They do not depend on how HDF5 arranges the file. `paths` are those of all
/// its objects (hdf5::object_paths). Where `image` has the bytes of the file, values are digested
/// there, after their checksums were found right; else HDF5 reads them. Throws std::runtime_error
/// naming the dataset that cannot be read.
Digests digests_of(hid_t file, const std::vector<std::string>& paths,
                   std::span<const std::byte> image = {});

/// The name of the attribute that holds a digest. The content digest is an attribute of the root,
/// the digest of the provenance one of the group /provenance.
inline const std::string digest_attribute = "digest";

}  // namespace piae::artefact
