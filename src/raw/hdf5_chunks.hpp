#pragma once

#include <hdf5.h>

#include "raw/array.hpp"

namespace piae::raw {

/// Throws Error(bad_input) if values were never written or are beyond the end of the file. Also
/// throws if chunks are beyond the extents, or if an unpacked chunk has the wrong size. HDF5's old
/// format has no checksum for the chunk index, the extents and the filters. After one flipped bit
/// there, HDF5 would read packed bytes as numbers, fill in zeros, read unverified bytes, or end
/// early.
void require_written(const Where& where, hid_t dataset);

}  // namespace piae::raw
