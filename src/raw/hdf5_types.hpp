#pragma once

#include <hdf5.h>

namespace piae::raw {

/// True for integers that fill their bytes, and for standard floats. HDF5's old format has no
/// checksum for types: one flipped bit there changes all values, or crashes libhdf5 1.10.
bool is_standard_number(hid_t type);

}  // namespace piae::raw
