#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "raw/signal.hpp"

namespace piae::raw {

/// True if a file with these first bytes is a universal file: the mark of a data set and its type.
bool is_uff(std::string_view beginning);

/// Reads a time record of a universal file: a data set 58, text or binary (58b). `variable` is its
/// number among data sets 58, counted from 1, or its first ID line. The abscissa's increment gives
/// the sample rate. Throws Error(bad_input) unless it is a time record with even spacing and the
/// declared number of values.
Signal read_uff(const std::filesystem::path& file, const std::string& variable);

}  // namespace piae::raw
