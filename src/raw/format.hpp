#pragma once

#include <filesystem>
#include <string>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads one signal of a file in this process.
using Read = Signal (*)(const std::filesystem::path& file, const std::string& variable);

/// The reader of a file's format, which its first bytes say, and where these are nobody's mark, its
/// extension; what has neither is text. Throws Error(bad_input) for a format that is known and not
/// read, with how to export it, and for a file that is not what its extension says.
Read reader_of(const std::filesystem::path& file);

}  // namespace piae::raw
