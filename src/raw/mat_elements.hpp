#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace piae::raw {

/// Header size of MATLAB files of version 5 or 7.3: text, then the version and "MI" or "IM" for the
/// byte order. Other files never reach libmatio, because it trusts the header of version 4.
inline constexpr std::size_t mat_header_bytes = 128;

/// Returns the version in the header, such as 0x0100 for 5; 0 for other files.
int mat_version(std::span<const std::byte> bytes);

/// True if a version 5 file is complete: a header, then elements of type and size (4 bytes each)
/// and content. libmatio does not report truncated files, but fills in the missing values.
bool is_whole_v5(std::span<const std::byte> bytes);

/// Returns how a complete version 5 file is damaged; empty if it is intact. libmatio would read it:
///   - the Adler-32 checksum (RFC 1950) at the end of a compressed element does not match; libmatio
///     stops reading before it;
///   - an array has more or fewer values than its dimensions, or a type that its class does not
///     store; libmatio trusts the dimensions and takes the bytes that follow;
///   - a part of a structure or cell array exceeds its end.
/// (MAT-File Format, MathWorks: level 5, "MAT-File Format".)
std::string flaw_of_v5(std::span<const std::byte> bytes);

}  // namespace piae::raw
