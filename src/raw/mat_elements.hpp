#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

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

/// Says how a whole file of version 5 is damaged; empty where it is not. libmatio would read it:
///   - a compressed element does not hold what was packed, by the checksum at the end of its stream
///     (Adler-32, RFC 1950), before which libmatio stops;
///   - an array has more or fewer values than its dimensions say, or of a type that its class does
///     not store: libmatio goes by the dimensions and takes bytes of what follows;
///   - a part of a structure or cell array goes beyond its end.
/// (MAT-File Format, MathWorks: level 5, "MAT-File Format".)
std::string flaw_of_v5(std::span<const std::byte> bytes);

}  // namespace piae::raw
