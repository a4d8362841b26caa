#include "page/report_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "page/problems.hpp"
#include "page/words.hpp"
#include "report/document.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/ratio_columns.hpp"

namespace piae::page {

namespace {

using report::AccuracyRow;

/// "85.4", with how many seeds where others have more: "85.4 (3)".
std::string short_mean(const AccuracyRow& row, std::size_t most_seeds) {
  const std::string mean = report::number_label(row.summary.mean, {.decimals = 1});
  return row.seeds.size() < most_seeds ? fmt::format("{} ({})", mean, row.seeds.size()) : mean;
}

std::string short_published(const AccuracyRow& row) {
  const std::optional<double> theirs = row.published ? row.published : row.orientation;
  return theirs ? report::number_label(*theirs, {.decimals = 1}) : "";
}

/// A line for our accuracies and one for the published ones, a ratio in each column.
text::Table main_table(const DatasetContents& contents) {
  const report::PaperReference reference(contents.name);
  const std::size_t most = report::most_seeds(contents.rows);
  const std::vector<report::RatioColumn> columns = report::ratio_columns(contents.rows);
  std::vector<std::string> header{"method", ""};
  for (const report::RatioColumn& column : columns) {
    header.push_back(report::short_ratio_label(column.ratio));
  }
  text::Table table(header, 2);
  for (const std::string& method : report::methods_of(contents.rows)) {
    std::vector<std::string> ours{report::method_label(method), "here"};
    std::vector<std::string> theirs{"", reference.label()};
    for (const report::RatioColumn& column : columns) {
      const auto row = std::ranges::find_if(contents.rows, [&](const AccuracyRow& each) {
        return each.method == method && each.ratio == column.ratio;
      });
      const bool is_there = row != contents.rows.end();
      ours.push_back(is_there ? short_mean(*row, most) : "");
      theirs.push_back(is_there ? short_published(*row) : "");
    }
    table.row(ours);
    const bool published = std::any_of(theirs.begin() + 2, theirs.end(),
                                       [](const std::string& text) { return !text.empty(); });
    if (published) table.row(theirs);
  }
  return table;
}

report::Section section_of(const DatasetContents& contents) {
  std::string note;
  for (const std::string& sentence : contents.verdict) note += (note.empty() ? "" : " ") + sentence;
  const report::PaperReference reference(contents.name);
  if (reference.beside() && !reference.beside()->own) {
    note += (note.empty() ? "" : " ") + std::string(reference.beside()->caution);
  }
  return {.key = contents.name,
          .title = "Accuracy on " + contents.name + ", percent, mean over seeds",
          .note = note,
          .table = main_table(contents)};
}

/// A line for each of the first groups of missing cells; the page has all of them.
std::vector<std::string> lines_of_missing(const std::vector<DatasetContents>& datasets) {
  constexpr std::size_t most_groups = 12;
  const std::vector<HoleGroup> groups = groups_of(datasets);
  std::vector<std::string> lines;
  for (const HoleGroup& group : groups) {
    if (lines.size() == most_groups) {
      lines.push_back(fmt::format("And {} more; report.html names all.", groups.size() - most_groups));
      break;
    }
    const std::string why = group.reasons.empty() ? "" : ": " + group.reasons.front();
    lines.push_back(fmt::format("{} on {}: {} ({}){}", word_of(group.state), group.dataset,
                                counted_cells(group.diagnoses, group.scores), cells_label(group), why));
  }
  return lines;
}

}  // namespace

std::string report_text(const ReportContents& contents) {
  report::Document document{.key = "report", .title = "PIAE-DT on " + names_of(contents.datasets)};
  document.paragraphs.push_back(completeness(contents.datasets));
  for (std::string& line : lines_of_missing(contents.datasets)) {
    document.paragraphs.push_back("- " + std::move(line));
  }
  std::string what;
  for (const auto& [word, said] : facts_of(contents.datasets)) {
    if (word != "What") what += (what.empty() ? "" : " ") + word + ": " + said + ".";
  }
  document.paragraphs.push_back(what);
  for (const DatasetContents& dataset : contents.datasets) {
    if (!dataset.rows.empty()) document.sections.push_back(section_of(dataset));
  }
  std::string text = report::markdown(document);
  return text + "\nFigures, recall by class, every cell with its artefact, settings and provenance: "
                "`report.html`.\nWhen the steps ran and what they took: `run.html`. All tables: `tables.md` of "
                "each data set.\n";
}

}  // namespace piae::page
