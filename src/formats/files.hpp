#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/exported.hpp"
#include "text/file.hpp"

namespace piae::formats {

/// Returns the files that hold windows in the format of the ending of `output`: .csv, .mat, .npy or
/// .wav. Since .npy and .wav hold only samples, NAME.labels.csv adds the facts of each window.
/// Throws Error(usage) for another ending.
std::vector<text::File> files_of(const Exported& exported, const std::filesystem::path& output);

/// Returns the paths of those files.
std::vector<std::filesystem::path> paths_of(const std::filesystem::path& output);

}  // namespace piae::formats
