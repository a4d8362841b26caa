#pragma once

#include <string>

namespace piae::page {

/// The same picture in fewer bytes: without groups that are empty, that only name a plot, or that
/// repeat the one before, and with short colours. Together with pipeline/figures/shorten.awk, which
/// shortens lines and marks when gnuplot draws, this lets a page hold all pictures of a run. A text
/// that is no XML is returned as it is.
std::string compact_svg(const std::string& svg);

}  // namespace piae::page
