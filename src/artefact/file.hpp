#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace piae::artefact {

/// All bytes of a file. Throws Error(input_missing) when there is none that can be read.
std::vector<std::byte> read_file(const std::filesystem::path& path);

/// Writes the bytes beside `path` as "<path>.partial", syncs them to the disk and renames the file,
/// so that whatever stands under `path` is complete: the old content, or the new. Missing parent
/// folders are made. Throws Error(failed), with the partial file removed, when the folder cannot be
/// written or the disk is full.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes a file, where there is one, and what a killed write of it has left.
void remove_file(const std::filesystem::path& path);

}  // namespace piae::artefact
