#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads one signal of a file in this process.
using Read = Signal (*)(const std::filesystem::path& file, const std::string& variable);

/// Returns the reader of a file's format. The first bytes determine the format; without a known
/// mark, the extension does. All other files are text, and so are .mat files of text. Throws
/// Error(bad_input) for a format that is not read, with how to export it. Also throws if a file
/// contradicts its extension.
Read reader_of(const std::filesystem::path& file);

}  // namespace piae::raw
