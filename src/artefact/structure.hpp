#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "artefact/hdf5.hpp"

namespace piae::artefact {

/// Throws std::runtime_error, naming the problem and the place, unless a file contains only what
/// Writer writes: groups and datasets in one tree of plain hard links, numbers and fixed-length
/// strings, one value an attribute, and in total no more bytes than the file has. Then nothing can
/// refer to other files, appear twice, or be larger than what was read.
///
/// Returns the paths of all objects, as hdf5::object_paths would. They are part of the digest and
/// define all links, because an additional link would be an additional object. `size` is the size
/// of the file in bytes.
std::vector<std::string> require_our_structure(hid_t file, std::size_t size);

}  // namespace piae::artefact
