#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace piae::raw {

/// Stands for a size that NI's description does not state, so the values cannot be skipped.
inline constexpr auto unstated_size = static_cast<std::size_t>(-1);

/// A type of values in a TDMS file (NI's enumeration tdsDataType).
struct TdmsType {
  std::uint32_t id;
  std::size_t size;  ///< bytes of a value; 0 if it varies, as for text; or unstated_size
  const char* name;
  /// Reads a value; null if the type does not hold real numbers.
  double (*read)(std::span<const std::byte> bytes, std::size_t at, bool big_endian);
};

inline constexpr std::uint32_t tdms_text = 0x20;

/// Returns the type with this number; null if it is unknown.
const TdmsType* tdms_type(std::uint32_t id);

}  // namespace piae::raw
