#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace piae::report {

/// A table with what must be said of it. All texts are plain, not Markdown or LaTeX.
struct Section {
  std::string key;    ///< short name, such as "accuracy-methods"
  std::string title;  ///< without a full stop
  std::string note;   ///< one paragraph; empty where there is nothing to say
  text::Table table;
  /// Sentences, each of which says what the table shows. They stand before the note in a document,
  /// and above the table on a page.
  std::vector<std::string> findings = {};
};

/// Tables with what must be said of them. It is put together once, and written as Markdown and
/// LaTeX.
struct Document {
  std::string key;  ///< short name, such as that of the dataset
  std::string title;
  std::vector<std::string> paragraphs = {};  ///< what holds for all tables
  std::vector<Section> sections = {};
};

/// No line is longer than 100 characters, but for titles and words that are. A table that would be
/// wider is written as several (text/table.hpp).
std::string markdown(const Document& document);

/// LaTeX for \input: the paragraphs, and a float for each table, with the label
/// tab:<document>-<section>. A comment at the beginning names the packages that are needed.
std::string latex(const Document& document);

}  // namespace piae::report
