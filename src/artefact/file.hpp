#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace piae::artefact {

/// All bytes of a file. Throws Error(input_missing) where it cannot be read.
std::vector<std::byte> read_file(const std::filesystem::path& path);

/// Writes a file so that it is always complete: until all is written the old content stands there.
/// The bytes are written to "<path>.partial" and synced to the disk, then the file is renamed.
/// Missing parent folders are made. Throws Error(failed) when the folder cannot be written or the
/// disk is full; nothing is left of the partial file then.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes a file, and its partial file that a killed program may have left. Either may be missing.
void remove_file(const std::filesystem::path& path);

}  // namespace piae::artefact
