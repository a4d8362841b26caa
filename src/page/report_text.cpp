#include "page/report_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "page/problems.hpp"
#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/recommendation_tables.hpp"
#include "report/summary.hpp"

namespace piae::page {

namespace {

/// A section for each classifier, of which the first begins with the verdict, and which method to
/// take.
std::vector<report::Section> sections_of(const DatasetContents& contents) {
  std::vector<report::Section> sections =
      report::overview_sections(contents.rows, contents.grid.seeds.size());
  if (!sections.empty()) sections.front().findings = contents.verdict;
  std::vector<report::Section> last = report::recommendation_sections(contents.recommendations);
  if (!last.empty()) sections.push_back(std::move(last.front()));
  return sections;
}

/// A line for each of the first groups of missing cells; the page has all of them.
std::vector<std::string> lines_of_missing(const std::vector<DatasetContents>& datasets) {
  constexpr std::size_t most_groups = 12;
  const std::vector<HoleGroup> groups = groups_of(datasets);
  std::vector<std::string> lines;
  for (const HoleGroup& group : groups) {
    if (lines.size() == most_groups) {
      lines.push_back(
          fmt::format("And {} more; report.html names all.", groups.size() - most_groups));
      break;
    }
    const std::string why = group.reasons.empty() ? "" : ": " + group.reasons.front();
    lines.push_back(fmt::format("{} on {}: {} ({}){}", word_of(group.state), group.dataset,
                                counted_cells(group.diagnoses, group.scores), cells_label(group),
                                why));
  }
  return lines;
}

}  // namespace

std::string report_text(const ReportContents& contents) {
  report::Document document{.key = "report", .title = "PIAE-DT on " + names_of(contents.datasets)};
  document.paragraphs.push_back(completeness(contents.datasets));
  for (const DatasetContents& dataset : contents.datasets) {
    const std::string left_out = report::left_out_line(dataset.results);
    if (!left_out.empty()) document.paragraphs.push_back(dataset.name + ": " + left_out + ".");
  }
  for (std::string& line : lines_of_missing(contents.datasets)) {
    document.paragraphs.push_back("- " + std::move(line));
  }
  std::string what;
  for (const auto& [word, said] : facts_of(contents.datasets)) {
    if (word != "What") what += fmt::format("{}{}: {}.", what.empty() ? "" : " ", word, said);
  }
  document.paragraphs.push_back(what);
  for (const DatasetContents& dataset : contents.datasets) {
    std::ranges::move(sections_of(dataset), std::back_inserter(document.sections));
  }
  std::string text = report::markdown(document);
  return text +
         "\nFigures, recall by class, every cell with its artefact, settings and provenance: "
         "`report.html`.\nWhen the steps ran and what they took: `run.html`. All tables: "
         "`tables.md` of each data set.\n";
}

}  // namespace piae::page
