#pragma once

#include "page/table.hpp"
#include "scoring/recall.hpp"

namespace piae::page {

/// A share in percent, with the windows that it is of.
Cell share_cell(const scoring::Share& share);

/// The same of windows that were recognised: the fewer, the stronger it is shaded.
Cell recall_cell(const scoring::Share& share);

}  // namespace piae::page
