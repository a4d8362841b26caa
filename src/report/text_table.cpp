#include "report/text_table.hpp"

#include <algorithm>

namespace piae::report {

namespace {

/// Characters on the screen: bytes of UTF-8 that do not continue a character.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

void TextTable::row(std::vector<std::string> cells) {
  cells.resize(rows_.front().size());
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);
  for (const auto& cells : rows_) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], width_of(cells[i]));
  }
  return widths;
}

std::string TextTable::padded(const std::string& cell, std::size_t column,
                              std::size_t width) const {
  const std::string space(width - width_of(cell), ' ');
  return column < left_columns_ ? cell + space : space + cell;
}

std::string TextTable::plain() const {
  const std::vector<std::size_t> width = widths();
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

std::string TextTable::markdown() const {
  const std::vector<std::size_t> width = widths();
  std::string rule = "|";
  for (std::size_t i = 0; i < width.size(); ++i) {
    rule += std::string(width[i] + 1, '-') + (i < left_columns_ ? "-|" : ":|");
  }
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    text += "|";
    for (std::size_t i = 0; i < width.size(); ++i) {
      text += ' ' + padded(rows_[r][i], i, width[i]) + " |";
    }
    text += '\n' + (r == 0 ? rule + '\n' : "");
  }
  return text;
}

}  // namespace piae::report
