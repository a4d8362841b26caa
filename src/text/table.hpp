#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace piae::text {

/// What a table says in one place, as plain text: each way of writing a table escapes what it must,
/// and takes of a cell what it has room for.
struct Cell {
  Cell() = default;
  Cell(std::string shown) : text(std::move(shown)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* shown) : text(shown) {}             // NOLINT(google-explicit-constructor)

  std::string text;                       ///< what people read
  std::optional<std::string> field = {};  ///< in CSV, which has more digits; the text where empty
  std::optional<double> number = {};      ///< what a page sorts by; the text where empty
  std::string looks = {};                 ///< class of the page's style sheet: "helps", "low-1"
  std::string source = {};                ///< artefacts that the number came from
  std::vector<std::string> more = {};  ///< further lines, on a page alone; empty ones are skipped
  std::vector<std::filesystem::path> files = {};  ///< linked on a page, before the text
  bool is_digest = false;                         ///< or another text to compare letter by letter
};
using Cells = std::vector<Cell>;

/// Which ways of writing show a column.
enum class Shown {
  everywhere,
  on_pages,  ///< and in CSV: there is no room in a document
  in_csv
};

struct Column {
  std::string heading;
  bool is_number = false;
  std::string field = {};  ///< its name in CSV; empty where CSV does not have it
  Shown shown = Shown::everywhere;
};

struct Row {
  Cells cells;
  std::string looks = {};  ///< class of the page's style sheet: "ceiling", "bad"
};

/// A table as data, and the ways in which it can be written; page/table.hpp writes it as HTML.
class Table {
 public:
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

  /// Without a column.
  Table() = default;
  /// The first `left_columns` columns hold words, which are aligned left; the others hold numbers,
  /// which are aligned right.
  Table(const std::vector<std::string>& headings, std::size_t left_columns);

  void column(Column column) { columns_.push_back(std::move(column)); }
  /// Adds a row. Cells may be missing at its end; they are empty. A row whose first cell is empty
  /// belongs to the row above it.
  void row(Cells cells, const std::string& looks = "");
  template <std::same_as<std::string> Text>
  void row(const std::vector<Text>& cells) {
    row(Cells(cells.begin(), cells.end()));
  }

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// For a terminal, with columns padded by spaces.
  [[nodiscard]] std::string plain() const;
  /// As Markdown, also padded, so that the file itself is easy to read. Where its lines would be
  /// longer than `widest` characters, it is written as several tables below each other: each has
  /// the columns of words and some of those of numbers. A column is never cut.
  [[nodiscard]] std::string markdown(std::size_t widest = no_limit) const;
  /// As a LaTeX tabular in the style of the package booktabs.
  [[nodiscard]] std::string latex() const;
  /// The columns that have a name in CSV.
  [[nodiscard]] std::string csv() const;

 private:
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace piae::text
