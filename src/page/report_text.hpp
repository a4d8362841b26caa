#pragma once

#include <string>

#include "page/report_page.hpp"

namespace piae::page {

/// report.md: what was run, what is missing, the verdict and the main table, for terminals and pull
/// requests. At most 100 columns wide. The same bytes for the same cells, as report_page().
std::string report_text(const ReportContents& contents);

}  // namespace piae::page
