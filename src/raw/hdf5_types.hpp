#pragma once

#include <hdf5.h>

namespace piae::raw {

/// True of integers that fill their bytes, and of floats as machines have them. In HDF5's old
/// format no checksum covers a type: one flipped bit there makes other numbers of all values, or
/// crashes libhdf5 1.10.
bool is_standard_number(hid_t type);

}  // namespace piae::raw
