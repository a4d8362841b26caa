#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace piae::artefact {

/// The checksum that HDF5 appends to a chunk of a dataset whose filter is fletcher32 (Fletcher
/// 1982, over words of two bytes, the first of which counts more). Computed by vectors,
/// some three times as fast as HDF5 does it. The number of bytes must be even.
std::uint32_t fletcher32(std::span<const std::byte> bytes);

}  // namespace piae::artefact
