#include "text/table.hpp"

#include <algorithm>
#include <numeric>

#include "text/escape.hpp"

namespace piae::text {

namespace {

/// Returns the number of characters on the screen: the UTF-8 bytes that start a character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Returns the width of the widest cell of each column.
std::vector<std::size_t> widths_of(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& cells : rows) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(cells[i]));
  }
  return widths;
}

/// Returns the width of a Markdown line of these columns, with bars and spaces.
std::size_t width_in_markdown(const std::vector<std::size_t>& columns,
                              const std::vector<std::size_t>& width) {
  std::size_t sum = 1;
  for (const std::size_t column : columns) sum += width[column] + 3;
  return sum;
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i > 0 ? " & " : "") + latex_text(cells[i]);
  return "  " + line + " \\\\\n";
}

}  // namespace

void Table::row(std::vector<std::string> cells) {
  cells.resize(rows_.front().size());
  rows_.push_back(std::move(cells));
}

std::string Table::padded(const std::string& cell, std::size_t column, std::size_t width) const {
  const std::string space(width - width_of(cell), ' ');
  return column < left_columns_ ? cell + space : space + cell;
}

std::string Table::plain() const {
  const std::vector<std::size_t> width = widths_of(rows_);
  std::string text;
  for (const auto& cells : rows_) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += (i > 0 ? "  " : "") + padded(cells[i], i, width[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string Table::markdown(std::size_t widest) const {
  Rows rows = rows_;
  for (auto& cells : rows) std::ranges::transform(cells, cells.begin(), markdown_text);
  const std::vector<std::size_t> width = widths_of(rows);
  const auto fits = [&](const Columns& columns) {
    return width_in_markdown(columns, width) <= widest;
  };
  std::size_t groups = 1;
  while (groups + left_columns_ < width.size() &&
         !std::ranges::all_of(columns_in_groups(groups), fits)) {
    ++groups;
  }
  std::string text;
  for (const Columns& columns : columns_in_groups(groups)) {
    text += (text.empty() ? "" : "\n") + markdown_of(rows, columns, width);
  }
  return text;
}

/// Divides the columns of numbers into groups of almost equal size, each after the columns of
/// words.
std::vector<Table::Columns> Table::columns_in_groups(std::size_t groups) const {
  const std::size_t numbers = rows_.front().size() - left_columns_;
  std::vector<Columns> all;
  for (std::size_t group = 0; group < groups; ++group) {
    Columns& columns = all.emplace_back(left_columns_);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    for (std::size_t i = numbers * group / groups; i < numbers * (group + 1) / groups; ++i) {
      columns.push_back(left_columns_ + i);
    }
  }
  return all;
}

std::string Table::markdown_of(const Rows& rows, const Columns& columns,
                               const std::vector<std::size_t>& width) const {
  std::string rule = "|";
  for (const std::size_t i : columns) {
    rule += std::string(width[i] + 1, '-') + (i < left_columns_ ? "-|" : ":|");
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += "|";
    for (const std::size_t i : columns) text += ' ' + padded(rows[r][i], i, width[i]) + " |";
    text += '\n' + (r == 0 ? rule + '\n' : "");
  }
  return text;
}

std::string Table::latex() const {
  const std::size_t columns = rows_.front().size();
  const auto goes_on = [](const auto& cells) { return cells.front().empty(); };
  const bool in_groups = std::any_of(rows_.begin() + 1, rows_.end(), goes_on);
  std::string text = "\\begin{tabular}{" + std::string(left_columns_, 'l') +
                     std::string(columns - left_columns_, 'r') + "}\n  \\toprule\n" +
                     latex_row(rows_.front()) + "  \\midrule\n";
  for (std::size_t r = 1; r < rows_.size(); ++r) {
    if (in_groups && r > 1 && !goes_on(rows_[r])) text += "  \\addlinespace\n";
    text += latex_row(rows_[r]);
  }
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

}  // namespace piae::text
