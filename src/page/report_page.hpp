#pragma once

#include <string>
#include <vector>

#include "page/contents.hpp"
#include "page/document.hpp"
#include "page/figures_view.hpp"
#include "text/file.hpp"

namespace piae::page {

/// All that a report is made from.
struct ReportContents {
  std::vector<DatasetContents> datasets;
  std::vector<std::vector<FigureContents>> figures;  ///< of each data set
  std::vector<text::File> settings = {};             ///< of RUN/.settings, paths below it, by name
};

/// Reads what the folder of a run holds; missing cells are listed. Throws Error as datasets_of()
/// and grid_of() do.
ReportContents read_report(const std::filesystem::path& run, const AskedCells& asked,
                           const report::Published& published);

/// Most mail servers still accept a page of this size.
inline constexpr std::size_t most_bytes_of_report = 15'000'000;

/// report.html. The same cells and figures give the same bytes in any folder, however often the run
/// was interrupted: there is no time, no host and no folder in it. It is not longer than
/// most_bytes_of_report as long as its tables are not; what does not fit is linked.
std::string report_page(const ReportContents& contents, const Style& style);

/// "cwru and hit-sm".
std::string names_of(const std::vector<DatasetContents>& datasets);

/// What was run, as pairs of a word and what it stands for: methods, ratios, seeds, split, cells.
std::vector<std::pair<std::string, std::string>> facts_of(
    const std::vector<DatasetContents>& datasets);

/// report.md: what was run, what is missing, the verdict and the main table, for terminals and pull
/// requests. At most 100 columns wide. The same bytes for the same cells, as report_page().
std::string report_text(const ReportContents& contents);

}  // namespace piae::page
