#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace piae::text {

/// Content of a cell as plain text. Each output format escapes it and uses the parts that it has
/// room for.
struct Cell {
  Cell() = default;
  Cell(std::string shown) : text(std::move(shown)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* shown) : text(shown) {}             // NOLINT(google-explicit-constructor)

  std::string text;                       ///< text for people
  std::optional<std::string> field = {};  ///< text in CSV, with more digits; `text` if empty
  std::optional<double> number = {};      ///< sort key on a page; `text` if empty
  std::string looks = {};                 ///< class of the page's style sheet: "helps", "low-1"
  std::string source = {};                ///< artefacts that the number came from
  std::vector<std::string> more = {};     ///< further lines, on pages only; empty ones are skipped
  std::vector<std::filesystem::path> files = {};  ///< linked on a page, before the text
  bool is_digest = false;  ///< digest or other text to compare letter by letter
};
using Cells = std::vector<Cell>;

/// Output formats that show a column.
enum class Shown {
  everywhere,
  on_pages,  ///< and in CSV; documents do not have room for it
  in_csv
};

struct Column {
  std::string heading;
  bool is_number = false;
  std::string field = {};  ///< its name in CSV; empty if CSV does not have the column
  Shown shown = Shown::everywhere;
};

struct Row {
  Cells cells;
  std::string looks = {};  ///< class of the page's style sheet: "ceiling", "bad"
};

/// A table as data, with its output formats; page/table.hpp writes HTML.
class Table {
 public:
  static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

  /// Has no columns.
  Table() = default;
  /// The first `left_columns` columns hold text and are aligned left; the others hold numbers and
  /// are aligned right.
  Table(const std::vector<std::string>& headings, std::size_t left_columns);

  void column(Column column) { columns_.push_back(std::move(column)); }
  /// Adds a row. Missing cells at its end are empty. A row with an empty first cell belongs to the
  /// row above it.
  void row(Cells cells, const std::string& looks = "");
  template <std::same_as<std::string> Text>
  void row(const std::vector<Text>& cells) {
    row(Cells(cells.begin(), cells.end()));
  }

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// Returns text for a terminal, with columns padded by spaces.
  [[nodiscard]] std::string plain() const;
  /// Returns Markdown, also padded, so that the file itself is easy to read. If a line would be
  /// longer than `widest` characters, returns several tables below each other: each has the text
  /// columns and some of the number columns. Columns are never cut.
  [[nodiscard]] std::string markdown(std::size_t widest = no_limit) const;
  /// Returns a LaTeX tabular in the style of the package booktabs.
  [[nodiscard]] std::string latex() const;
  /// Returns the columns that have a name in CSV.
  [[nodiscard]] std::string csv() const;

 private:
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace piae::text
