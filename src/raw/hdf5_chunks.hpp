#pragma once

#include <hdf5.h>

#include "raw/array.hpp"

namespace piae::raw {

/// Throws Error(bad_input) where a dataset has values that were never written, or a chunk whose
/// filters are said to be left out though its size is that of filtered bytes. In files of HDF5's
/// old format no checksum covers the index of chunks: one flipped bit there would have HDF5 read
/// packed bytes as numbers, or fill in zeros.
void require_written(const Where& where, hid_t dataset);

}  // namespace piae::raw
