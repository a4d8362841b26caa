#include "text/table.hpp"

#include <algorithm>
#include <numeric>

#include "text/csv.hpp"
#include "text/escape.hpp"

namespace piae::text {

namespace {

/// Returns the width of a text on the screen: the number of bytes that start a UTF-8 character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The part of a table that a document shows.
struct Lines {
  std::vector<std::vector<std::string>> rows;  ///< the first is the header
  std::size_t left_columns = 0;                ///< number of text columns, which come first

  /// Returns for each column the width of its widest cell.
  [[nodiscard]] std::vector<std::size_t> widths() const {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& cells : rows) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        widths[i] = std::max(widths[i], width_of(cells[i]));
      }
    }
    return widths;
  }

  [[nodiscard]] std::string padded(std::size_t row, std::size_t column, std::size_t width) const {
    const std::string& cell = rows[row][column];
    const std::string space(width - width_of(cell), ' ');
    return column < left_columns ? cell + space : space + cell;
  }
};

Lines lines_of(const Table& table, std::string (*escape)(const std::string&)) {
  std::vector<std::size_t> shown;
  Lines lines{.rows = {{}}};
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const Column& column = table.columns()[i];
    if (column.shown != Shown::everywhere) continue;
    if (!column.is_number && lines.left_columns == shown.size()) ++lines.left_columns;
    shown.push_back(i);
    lines.rows.front().push_back(escape(column.heading));
  }
  for (const Row& row : table.rows()) {
    auto& cells = lines.rows.emplace_back();
    for (const std::size_t i : shown) cells.push_back(escape(row.cells[i].text));
  }
  return lines;
}

/// Numbers of some columns.
using Columns = std::vector<std::size_t>;

/// Returns the width of a Markdown line of these columns, with bars and spaces.
std::size_t width_in_markdown(const Columns& columns, const std::vector<std::size_t>& width) {
  std::size_t sum = 1;
  for (const std::size_t column : columns) sum += width[column] + 3;
  return sum;
}

/// Splits the number columns into groups of nearly equal size. Each group also has all text
/// columns.
std::vector<Columns> columns_in_groups(const Lines& lines, std::size_t groups) {
  const std::size_t numbers = lines.rows.front().size() - lines.left_columns;
  std::vector<Columns> all;
  for (std::size_t group = 0; group < groups; ++group) {
    Columns& columns = all.emplace_back(lines.left_columns);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    for (std::size_t i = numbers * group / groups; i < numbers * (group + 1) / groups; ++i) {
      columns.push_back(lines.left_columns + i);
    }
  }
  return all;
}

std::string markdown_of(const Lines& lines, const Columns& columns,
                        const std::vector<std::size_t>& width) {
  std::string rule = "|";
  for (const std::size_t i : columns) {
    rule += std::string(width[i] + 1, '-') + (i < lines.left_columns ? "-|" : ":|");
  }
  std::string text;
  for (std::size_t r = 0; r < lines.rows.size(); ++r) {
    text += "|";
    for (const std::size_t i : columns) text += ' ' + lines.padded(r, i, width[i]) + " |";
    text += '\n' + (r == 0 ? rule + '\n' : "");
  }
  return text;
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? " & " : "") + cells[i];
  return "  " + line + " \\\\\n";
}

}  // namespace

Table::Table(const std::vector<std::string>& headings, std::size_t left_columns) {
  for (const std::string& heading : headings) {
    columns_.push_back({.heading = heading, .is_number = columns_.size() >= left_columns});
  }
}

void Table::row(Cells cells, const std::string& looks) {
  cells.resize(columns_.size());
  rows_.push_back({std::move(cells), looks});
}

std::string Table::plain() const {
  const Lines lines = lines_of(*this, [](const std::string& text) { return text; });
  const std::vector<std::size_t> width = lines.widths();
  std::string text;
  for (std::size_t r = 0; r < lines.rows.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < width.size(); ++i) {
      line += (i > 0 ? "  " : "") + lines.padded(r, i, width[i]);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string Table::markdown(std::size_t widest) const {
  const Lines lines = lines_of(*this, markdown_text);
  const std::vector<std::size_t> width = lines.widths();
  const auto fits = [&](const Columns& columns) {
    return width_in_markdown(columns, width) <= widest;
  };
  std::size_t groups = 1;
  while (groups + lines.left_columns < width.size() &&
         !std::ranges::all_of(columns_in_groups(lines, groups), fits)) {
    ++groups;
  }
  std::string text;
  for (const Columns& columns : columns_in_groups(lines, groups)) {
    text += (text.empty() ? "" : "\n") + markdown_of(lines, columns, width);
  }
  return text;
}

std::string Table::latex() const {
  const Lines lines = lines_of(*this, latex_text);
  const std::size_t columns = lines.rows.front().size();
  const auto goes_on = [](const auto& cells) { return cells.front().empty(); };
  const bool in_groups = std::any_of(lines.rows.begin() + 1, lines.rows.end(), goes_on);
  std::string text = "\\begin{tabular}{" + std::string(lines.left_columns, 'l') +
                     std::string(columns - lines.left_columns, 'r') + "}\n  \\toprule\n" +
                     latex_row(lines.rows.front()) + "  \\midrule\n";
  for (std::size_t r = 1; r < lines.rows.size(); ++r) {
    if (in_groups && r > 1 && !goes_on(lines.rows[r])) text += "  \\addlinespace\n";
    text += latex_row(lines.rows[r]);
  }
  return text + "  \\bottomrule\n\\end{tabular}\n";
}

std::string Table::csv() const {
  std::vector<std::string> names;
  for (const Column& column : columns_) {
    if (!column.field.empty()) names.push_back(column.field);
  }
  std::string text = csv_line(names);
  for (const Row& row : rows_) {
    std::vector<std::string> fields;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Cell& cell = row.cells[i];
      if (!columns_[i].field.empty()) fields.push_back(cell.field.value_or(cell.text));
    }
    text += csv_line(fields);
  }
  return text;
}

}  // namespace piae::text
