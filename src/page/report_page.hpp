#pragma once

#include <string>
#include <vector>

#include "page/contents.hpp"
#include "page/document.hpp"
#include "page/figures_view.hpp"
#include "text/file.hpp"

namespace piae::page {

/// Everything that a report is made from.
struct ReportContents {
  std::vector<DatasetContents> datasets;
  std::vector<std::vector<FigureContents>> figures;  ///< for each data set
  std::vector<text::File> settings =
      {};  ///< files of RUN/.settings by name, with paths relative to it
};

/// Reads the folder of a run; lists missing cells. Throws Error as datasets_of() and grid_of() do.
ReportContents read_report(const std::filesystem::path& run, const RequestedCells& requested,
                           const report::Published& published);

/// Size of a page that most mail servers still accept.
inline constexpr std::size_t most_bytes_of_report = 15'000'000;

/// Returns report.html. The same cells and figures give the same bytes in any folder, however often
/// the run was interrupted: the page has neither times nor hosts nor folders. If its tables fit
/// into most_bytes_of_report, the page does; files that do not fit are linked.
std::string report_page(const ReportContents& contents, const Style& style);

/// Returns "cwru and hit-sm".
std::string names_of(const std::vector<DatasetContents>& datasets);

/// Returns facts of the run as pairs of a heading and a text: methods, ratios, seeds, split, cells.
std::vector<std::pair<std::string, std::string>> facts_of(
    const std::vector<DatasetContents>& datasets);

/// Returns report.md for terminals and pull requests: facts, missing cells, the verdict and the
/// main table, at most 100 columns wide. The same cells give the same bytes, as in report_page().
std::string report_text(const ReportContents& contents);

}  // namespace piae::page
