#include "raw/hdf5_types.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace piae::raw {

namespace {

/// True for IEEE 754 binary16, which HDF5 1.10 has no name for.
bool is_half(hid_t type) {
  std::size_t sign = 0;
  std::size_t exponent = 0;
  std::size_t exponent_bits = 0;
  std::size_t fraction = 0;
  std::size_t fraction_bits = 0;
  if (H5Tget_size(type) != 2 ||
      H5Tget_fields(type, &sign, &exponent, &exponent_bits, &fraction, &fraction_bits) < 0) {
    return false;
  }
  return sign == 15 && exponent == 10 && exponent_bits == 5 && fraction == 0 &&
         fraction_bits == 10 && H5Tget_ebias(type) == 15 && H5Tget_norm(type) == H5T_NORM_IMPLIED;
}

}  // namespace

bool is_standard_number(hid_t type) {
  if (H5Tget_class(type) == H5T_INTEGER) {
    constexpr std::size_t most_bytes = 8;
    const std::size_t bytes = H5Tget_size(type);
    return bytes <= most_bytes && H5Tget_precision(type) == 8 * bytes && H5Tget_offset(type) == 0;
  }
  const std::array floats{H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE,
                          H5T_NATIVE_LDOUBLE};
  return is_half(type) ||
         std::ranges::any_of(floats, [&](hid_t other) { return H5Tequal(type, other) > 0; });
}

}  // namespace piae::raw
