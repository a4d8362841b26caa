#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// Throws std::runtime_error, which says what and where, for a file that holds anything but what
/// Writer writes: groups and datasets in one tree of plain hard links, numbers and fixed-length
/// strings, one value an attribute, and together no more bytes than the file has. Nothing can then
/// lead out of the file, be found in two places, or be larger than what was read of it.
///
/// The paths of all objects, which are in the digest, then say all links that there are: a link
/// more or less is an object more or less. They are returned as hdf5::object_paths would. `size` is
/// that of the file in bytes.
std::vector<std::string> require_our_structure(hid_t file, std::size_t size);

}  // namespace piae::artefact
