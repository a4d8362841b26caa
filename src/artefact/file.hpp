#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>

#include "base/bytes.hpp"

namespace piae::artefact {

/// Returns all bytes of a file. Throws Error(input_missing) if it cannot be read or is not a
/// regular file; a pipe would block. Throws Error(bad_input), before reading, if it has more than
/// `most` bytes: a sparse file can claim any size.
Bytes read_file(const std::filesystem::path& path,
                std::uint64_t most = std::numeric_limits<std::int64_t>::max());

/// Throws Error(failed) if something other than a regular file has this path, such as a planted
/// link, and Error(usage) if the path does not end with a name. Call this before a long
/// computation.
void require_replaceable(const std::filesystem::path& path);

/// Writes a file atomically: the old content remains until the new content is complete. Writes the
/// bytes to a file next to it (partial_file.hpp), syncs and renames it. Makes missing parent
/// folders. Throws Error(failed) if the folder cannot be written, the disk is full, or the path is
/// a link or not a regular file; then the partial file is removed.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes a file, if it exists, and the partial files that killed programs have left of it.
void remove_file(const std::filesystem::path& path);

}  // namespace piae::artefact
