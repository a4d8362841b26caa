#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats/exported.hpp"
#include "text/file.hpp"

namespace piae::formats {

/// The files that hold windows in the format that the ending of `output` asks for: .csv, .mat, .npy
/// or .wav. Beside .npy and .wav, which hold samples alone, there is NAME.labels.csv with what is
/// known of each window. Throws Error(usage) for another ending.
std::vector<text::File> files_of(const Exported& exported, const std::filesystem::path& output);

/// The paths of those files.
std::vector<std::filesystem::path> paths_of(const std::filesystem::path& output);

}  // namespace piae::formats
