#include "report/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "diagnosis/catalogue.hpp"
#include "report/accuracies.hpp"
#include "report/accuracy_table.hpp"
#include "report/columns.hpp"
#include "report/labels.hpp"
#include "report/paper.hpp"
#include "report/recommendation_tables.hpp"
#include "report/verdict.hpp"
#include "text/table.hpp"
#include "text/wrap.hpp"

namespace piae::report {

namespace {

constexpr std::size_t widest_paragraph = 80;

std::string wrapped_at_80(const std::string& paragraph) {
  return text::wrap(paragraph, widest_paragraph);
}

text::Cell shown_mean(const AccuracyRow& row) {
  return number_cell(row.summary.mean, percent_style);
}

std::string accuracy_tables(const std::vector<AccuracyRow>& rows) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  std::string text;
  for (const ClassifierRows& block : blocks) {
    if (blocks.size() > 1)
      text +=
          (text.empty() ? "" : "\n") + ("by " + diagnosis::marked_name(block.classifier)) + '\n';
    text +=
        ratio_matrix(block.rows, block.reference_row, {.short_ratios = true, .cell_of = shown_mean})
            .plain();
    const std::string types = types_sentence(block);
    if (!types.empty()) text += '\n' + wrapped_at_80(types);
  }
  return text;
}

/// Returns "" if nothing can be recommended.
std::string recommendation_paragraph(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results) {
  const std::vector<Recommendation> all = recommendations(rows, results);
  const Recommendation* const main = main_recommendation(all);
  std::string text;
  if (main == nullptr) return text;
  for (const std::string& sentence : recommendation_sentences(*main)) text += sentence + ' ';
  return text;
}

bool is_none(const AccuracyRow& row) { return row.method == augment::no_method; }

/// Returns "61.2/85.4", ours and the published number, or "61.2" if nothing is published. Marks a
/// mean of fewer seeds than the run has.
std::string beside_published(const AccuracyRow& row, std::size_t seeds) {
  return number_label(row.summary.mean, percent_style) +
         (row.seeds.size() < seeds ? mark_of_fewer_seeds : "") +
         (row.theirs() ? "/" + number_label(*row.theirs(), percent_style) : "");
}

/// Shows `none` only if there is nothing else: it has its own ratio, and the title names it.
text::Table overview_table(std::vector<AccuracyRow> rows, std::size_t seeds) {
  if (!std::ranges::all_of(rows, is_none)) std::erase_if(rows, is_none);
  return ratio_matrix(rows, {}, {.short_ratios = true, .cell_of = [&](const AccuracyRow& row) {
                                   return beside_published(row, seeds);
                                 }});
}

std::string overview_title(const ClassifierRows& block, std::size_t seeds) {
  const bool is_papers = block.classifier == scoring::paper_classifier;
  std::string title = "Accuracy on " + block.rows.front().dataset + ", percent" +
                      (is_papers ? "" : ", by " + diagnosis::marked_name(block.classifier));
  const auto none = std::ranges::find_if(block.rows, is_none);
  if (none == block.rows.end()) return title;
  return title + "; without generated windows " + beside_published(*none, seeds);
}

/// Explains the numbers of a table.
std::string how_to_read_overview(const ClassifierRows& block, std::size_t seeds) {
  const PaperReference reference(block.rows.front().dataset, block.classifier);
  std::string text;
  if (reference.counterpart()) {
    text +=
        fmt::format(" Numbers are ours/the paper's for {}.", reference.counterpart()->paper.title);
    if (!reference.counterpart()->own) text += " " + std::string(reference.counterpart()->caution);
  }
  const bool any_fewer = std::ranges::any_of(
      block.rows, [&](const AccuracyRow& row) { return row.seeds.size() < seeds; });
  return any_fewer
             ? text + " " + mark_of_fewer_seeds + " marks means of fewer seeds than the run has."
             : text;
}

}  // namespace

std::vector<Section> overview_sections(const std::vector<AccuracyRow>& rows, std::size_t seeds) {
  std::vector<Section> sections;
  for (const ClassifierRows& block : by_classifier(rows)) {
    sections.push_back({.key = rows.front().dataset,
                        .title = overview_title(block, seeds),
                        .note = how_to_read_overview(block, seeds),
                        .table = overview_table(block.rows, seeds)});
  }
  return sections;
}

std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows) {
  const auto has_all = [&](const AccuracyRow& row) {
    return row.seeds.size() == grid.seeds.size();
  };
  const std::string conditions = conditions_note(results);
  std::string text = fmt::format("Accuracy on {} in percent, mean of {}{}\n", grid.dataset,
                                 std::ranges::all_of(rows, has_all) ? "" : "up to ",
                                 counted(grid.seeds.size(), "seed"));
  if (!conditions.empty()) text += wrapped_at_80(conditions);
  text += '\n' + accuracy_tables(rows);
  std::string sentences;
  for (const std::string& sentence : verdict(results, rows)) sentences += wrapped_at_80(sentence);
  if (!sentences.empty()) text += '\n' + sentences;
  const std::string recommended = recommendation_paragraph(rows, results);
  return recommended.empty() ? text : text + '\n' + wrapped_at_80(recommended);
}

}  // namespace piae::report
