#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <span>

#include "base/bytes.hpp"

namespace piae::artefact {

/// All bytes of a file. Throws Error(input_missing) where it cannot be read, or is no file: a pipe
/// is not waited for. Throws Error(bad_input), before anything is read, where it has more than
/// `most` bytes: a file may say that it is huge and take no room on the disk.
Bytes read_file(const std::filesystem::path& path,
                std::uint64_t most = std::numeric_limits<std::int64_t>::max());

/// What stands where a file is to be written must be a file itself: a link may have been planted.
/// Throws Error(failed) where it is not, and Error(usage) for a path that ends with no name. Who
/// computes for long asks before.
void require_replaceable(const std::filesystem::path& path);

/// Writes a file so that it is always complete: until all is written the old content stands there.
/// The bytes are written to a file beside it (partial_file.hpp) and synced to the disk, then that
/// file is renamed. Missing parent folders are made. Throws Error(failed) when the folder cannot be
/// written, the disk is full, or a link or something else that is no file stands there; nothing is
/// left of the partial file then.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes a file, and the partial files that killed programs may have left of it. There may be
/// none.
void remove_file(const std::filesystem::path& path);

}  // namespace piae::artefact
