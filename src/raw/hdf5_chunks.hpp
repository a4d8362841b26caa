#pragma once

#include <hdf5.h>

#include "raw/array.hpp"

namespace piae::raw {

/// Throws Error(bad_input) where a dataset has values that were never written, or a chunk that is
/// not packed and has another size than its values. In files of HDF5's old format no checksum
/// covers the index of chunks: one flipped bit there would have HDF5 read packed bytes as numbers,
/// fill in zeros, or read beyond what it verified.
void require_written(const Where& where, hid_t dataset);

}  // namespace piae::raw
