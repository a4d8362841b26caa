#pragma once

#include <hdf5.h>

namespace piae {

/// Returns access properties for a new file in the oldest format of HDF5, which has no checksums.
/// HDF5 2 chooses a newer one by itself.
inline hid_t oldest_format() {
  static const hid_t access = [] {
    const hid_t made = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(made, H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST);
    return made;
  }();
  return access;
}

}  // namespace piae
