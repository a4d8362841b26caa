#include "page/report_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "augment/catalogue.hpp"
#include "page/problems.hpp"
#include "page/words.hpp"
#include "report/classifier_rows.hpp"
#include "report/document.hpp"
#include "report/gaps.hpp"
#include "report/labels.hpp"
#include "report/paper_reference.hpp"
#include "report/ratio_columns.hpp"
#include "report/recommendation_tables.hpp"

namespace piae::page {

namespace {

using report::AccuracyRow;

std::string one_decimal(double number) { return report::number_label(number, {.decimals = 1}); }

/// "61.2/85.4": here, and as published; "61.2" where nothing is. A sign marks the mean of fewer
/// seeds than the run has.
std::string beside_published(const AccuracyRow& row, std::size_t seeds) {
  const std::optional<double> theirs = row.published ? row.published : row.orientation;
  return one_decimal(row.summary.mean) +
         (row.seeds.size() < seeds ? report::mark_of_fewer_seeds : "") +
         (theirs ? "/" + one_decimal(*theirs) : "");
}

bool is_none(const AccuracyRow& row) { return row.method == augment::no_method; }

/// A method in each row, a ratio in each column. `none`, which has a ratio of its own, is in the
/// title, and in the table where there is nothing else.
text::Table main_table(std::vector<AccuracyRow> rows, std::size_t seeds) {
  if (!std::ranges::all_of(rows, is_none)) std::erase_if(rows, is_none);
  const std::vector<report::RatioColumn> columns = report::ratio_columns(rows);
  std::vector<std::string> header{"method"};
  for (const report::RatioColumn& column : columns) {
    header.push_back(report::short_ratio_label(column.ratio));
  }
  text::Table table(header, 1);
  for (const std::string& method : report::methods_of(rows)) {
    std::vector<std::string> cells{report::method_label(method)};
    for (const report::RatioColumn& column : columns) {
      const auto row = std::ranges::find_if(rows, [&](const AccuracyRow& each) {
        return each.method == method && each.ratio == column.ratio;
      });
      cells.push_back(row == rows.end() ? "" : beside_published(*row, seeds));
    }
    table.row(cells);
  }
  return table;
}

std::string title_of(const DatasetContents& contents, const report::ClassifierRows& block) {
  const bool is_papers = block.classifier == scoring::paper_classifier;
  std::string title =
      "Accuracy on " + contents.name + ", percent" + (is_papers ? "" : ", by " + block.classifier);
  const auto none = std::ranges::find_if(block.rows, is_none);
  if (none == block.rows.end()) return title;
  return title + "; without generated windows " +
         beside_published(*none, contents.grid.seeds.size());
}

/// How to read the numbers of a table, as far as it has them.
std::string how_to_read(const DatasetContents& contents, const report::ClassifierRows& block) {
  const report::PaperReference reference(contents.name, block.classifier);
  std::string text;
  if (reference.beside()) {
    text +=
        " Numbers are ours/the paper's of " + std::string(reference.beside()->paper.title) + ".";
  }
  if (reference.beside() && !reference.beside()->own) {
    text += " " + std::string(reference.beside()->caution);
  }
  const bool any_fewer = std::ranges::any_of(block.rows, [&](const AccuracyRow& row) {
    return row.seeds.size() < contents.grid.seeds.size();
  });
  return any_fewer ? text + " " + report::mark_of_fewer_seeds +
                         " marks means of fewer seeds than the run has."
                   : text;
}

/// A section for each classifier, of which the first begins with the verdict, and which method to
/// take.
std::vector<report::Section> sections_of(const DatasetContents& contents) {
  std::string note;
  for (const std::string& sentence : contents.verdict) note += sentence + " ";
  std::vector<report::Section> sections;
  for (const report::ClassifierRows& block : report::by_classifier(contents.rows)) {
    sections.push_back({.key = contents.name,
                        .title = title_of(contents, block),
                        .note = note + how_to_read(contents, block),
                        .table = main_table(block.rows, contents.grid.seeds.size())});
    note.clear();
  }
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
