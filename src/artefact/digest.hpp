#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// Group that records how an artefact was made. The content digest excludes it.
inline const std::string provenance_group = "/provenance";

struct Digests {
  /// Covers everything but the provenance and the digests themselves.
  std::string content;
  /// Covers only the provenance group.
  std::string provenance;
};

/// Returns SHA-256 over the path, type, shape and values of every dataset and attribute, in
/// alphabetical order. The result does not depend on the layout that HDF5 chose. `paths` lists all
/// objects of the file (hdf5::object_paths). If `image` holds the bytes of the file, values are
/// read there after their checksums were verified; else by HDF5. Throws std::runtime_error naming a
/// dataset that cannot be read.
Digests digests_of(hid_t file, const std::vector<std::string>& paths,
                   std::span<const std::byte> image = {});

/// Attribute that holds a digest: the content digest at the root, the digest of the provenance at
/// the group /provenance.
inline const std::string digest_attribute = "digest";

}  // namespace piae::artefact
