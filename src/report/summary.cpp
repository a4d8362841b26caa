#include "report/summary.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <sstream>

#include "augment/catalogue.hpp"
#include "report/labels.hpp"
#include "report/ratio_columns.hpp"
#include "report/verdict.hpp"
#include "text/table.hpp"

namespace piae::report {

namespace {

constexpr std::size_t widest_paragraph = 80;

std::string wrapped_at_80(const std::string& paragraph) {
  std::istringstream words(paragraph);
  std::string text;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > widest_paragraph) {
      text += '\n';
      column = 0;
    }
    if (column > 0) text += ' ';
    text += word;
    column += (column > 0 ? 1 : 0) + word.size();
  }
  return text + '\n';
}

text::Table accuracy_table(const std::vector<AccuracyRow>& rows) {
  const std::vector<RatioColumn> columns = ratio_columns(rows);
  std::vector<std::string> header{"method"};
  for (const RatioColumn& column : columns) {
    header.push_back(short_ratio_label(column.ratio));
  }
  text::Table table(header, 1);
  for (const std::string& method : methods_of(rows)) {
    std::vector<std::string> cells{method_label(method)};
    for (const RatioColumn& column : columns) {
      const auto row = std::ranges::find_if(rows, [&](const AccuracyRow& each) {
        return each.method == method && each.ratio == column.ratio;
      });
      cells.push_back(row == rows.end() ? "" : number_label(row->summary.mean, {.decimals = 1}));
    }
    table.row(cells);
  }
  return table;
}

}  // namespace

std::string summary_text(const run::Grid& grid, const run::Results& results,
                         const std::vector<AccuracyRow>& rows) {
  const auto has_all = [&](const AccuracyRow& row) {
    return row.seeds.size() == grid.seeds.size();
  };
  std::string text = fmt::format("Accuracy on {} in percent, mean of {}{} seed{}\n\n", grid.dataset,
                                 std::ranges::all_of(rows, has_all) ? "" : "up to ",
                                 grid.seeds.size(), grid.seeds.size() == 1 ? "" : "s") +
                     accuracy_table(rows).plain();
  std::string sentences;
  for (const std::string& sentence : verdict(results, rows)) sentences += wrapped_at_80(sentence);
  return sentences.empty() ? text : text + '\n' + sentences;
}

}  // namespace piae::report
