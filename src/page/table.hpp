#pragma once

#include "page/html.hpp"
#include "report/document.hpp"

namespace piae::page {

/// A table that scrolls in a box of its own where the window is too narrow for it, with its note
/// below. A number says, when pointed at, what it came from. The page's script sorts a table by a
/// click on a column's heading, and filters it where it is long. The findings are left to views.
Html html(const report::Section& section);

}  // namespace piae::page
