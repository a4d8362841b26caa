#pragma once

#include "page/html.hpp"
#include "report/document.hpp"

namespace piae::page {

/// Returns a table with its note below. The table scrolls in its own box if the window is too
/// narrow. Pointing at a number shows its source. The page's script sorts a table by a click on a
/// heading, and filters long tables. Views place the findings.
Html html(const report::Section& section);

}  // namespace piae::page
