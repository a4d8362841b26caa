#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace piae::raw {

/// How a MATLAB file of version 5 or 7.3 begins: text, and then the version and "MI" or "IM", for
/// the order of bytes. libmatio is given no other file: it takes those of version 4 at their word.
inline constexpr std::size_t mat_header_bytes = 128;

/// The version as the header has it, such as 0x0100 for 5; 0 where it is no such file.
int mat_version(std::span<const std::byte> bytes);

/// True if a file of version 5 is complete: behind the header, one element after another, each with
/// its type and size (4 bytes each) and its content. libmatio does not say when a file is
/// truncated, but fills up the missing values.
bool is_whole_v5(std::span<const std::byte> bytes);

/// True if every compressed element of a whole file of version 5 holds what was packed, by the
/// checksum at the end of its stream (Adler-32, RFC 1950). libmatio stops before that checksum, so
/// a flipped bit would give other numbers.
bool is_intact_v5(std::span<const std::byte> bytes);

}  // namespace piae::raw
