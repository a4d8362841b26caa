#pragma once

#include <hdf5.h>

#include "raw/array.hpp"

namespace piae::raw {

/// Throws Error(bad_input) where a dataset has values that were never written or stand beyond the
/// end of its file, chunks beyond its extents, or a chunk that is not packed and has another size
/// than its values. In files of HDF5's old format no checksum covers the index of chunks, nor what
/// the dataset says of its extents and filters: one flipped bit there would have HDF5 read packed
/// bytes as numbers, fill in zeros, read beyond what it verified, or end early.
void require_written(const Where& where, hid_t dataset);

}  // namespace piae::raw
