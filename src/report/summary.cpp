#include "report/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "augment/catalogue.hpp"
#include "report/classifier_rows.hpp"
#include "report/condition_notes.hpp"
#include "report/labels.hpp"
#include "report/ratio_columns.hpp"
#include "report/recommendation_words.hpp"
#include "report/verdict.hpp"
#include "text/table.hpp"
#include "text/wrap.hpp"

namespace piae::report {

namespace {

constexpr std::size_t widest_paragraph = 80;

std::string wrapped_at_80(const std::string& paragraph) {
  return text::wrap(paragraph, widest_paragraph);
}

text::Table accuracy_table(const ClassifierRows& block) {
  std::vector<AccuracyRow> all = block.rows;
  if (block.bar) all.push_back(*block.bar);
  const std::vector<RatioColumn> columns = ratio_columns(all);
  std::vector<std::string> header{"method"};
  for (const RatioColumn& column : columns) {
    header.push_back(short_ratio_label(column.ratio));
  }
  text::Table table(header, 1);
  const auto add_line = [&](const std::string& name, const std::vector<AccuracyRow>& own) {
    std::vector<std::string> cells{name};
    for (const RatioColumn& column : columns) {
      const auto row = std::ranges::find(own, column.ratio, &AccuracyRow::ratio);
      cells.push_back(row == own.end() ? "" : number_label(row->summary.mean, {.decimals = 1}));
    }
    table.row(cells);
  };
  for (const std::string& method : methods_of(block.rows)) {
    add_line(method_label(method), rows_of(block.rows, method));
  }
  if (block.bar) add_line(bar_label(*block.bar), {*block.bar});
  return table;
}

std::string accuracy_tables(const std::vector<AccuracyRow>& rows) {
  const std::vector<ClassifierRows> blocks = by_classifier(rows);
  std::string text;
  for (const ClassifierRows& block : blocks) {
    if (blocks.size() > 1) text += (text.empty() ? "" : "\n") + ("by " + block.classifier) + '\n';
    text += accuracy_table(block).plain();
    const std::string kinds = kinds_sentence(block);
    if (!kinds.empty()) text += '\n' + wrapped_at_80(kinds);
  }
  return text;
}

/// Empty where nothing can be recommended.
std::string recommendation_paragraph(const std::vector<AccuracyRow>& rows,
                                     const run::Results& results) {
  const std::vector<Recommendation> all = recommendations(rows, results);
  const Recommendation* const main = main_recommendation(all);
  std::string text;
  if (main == nullptr) return text;
  for (const std::string& sentence : recommendation_sentences(*main)) text += sentence + ' ';
  return text;
}

}  // namespace

std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows) {
  const auto has_all = [&](const AccuracyRow& row) {
    return row.seeds.size() == grid.seeds.size();
  };
  const std::string conditions = conditions_note(results);
  std::string text = fmt::format("Accuracy on {} in percent, mean of {}{} seed{}\n", grid.dataset,
                                 std::ranges::all_of(rows, has_all) ? "" : "up to ",
                                 grid.seeds.size(), grid.seeds.size() == 1 ? "" : "s");
  if (!conditions.empty()) text += wrapped_at_80(conditions);
  text += '\n' + accuracy_tables(rows);
  std::string sentences;
  for (const std::string& sentence : verdict(results, rows)) sentences += wrapped_at_80(sentence);
  if (!sentences.empty()) text += '\n' + sentences;
  const std::string recommended = recommendation_paragraph(rows, results);
  return recommended.empty() ? text : text + '\n' + wrapped_at_80(recommended);
}

}  // namespace piae::report
