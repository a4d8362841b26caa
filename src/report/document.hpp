#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace piae::report {

/// A table with its explanations. All texts are plain, not Markdown or LaTeX.
struct Section {
  std::string key;    ///< short name, such as "accuracy-methods"
  std::string title;  ///< without a full stop
  std::string note;   ///< one paragraph; may be empty
  text::Table table;
  /// Sentences on what the table shows. A document prints them before the note, a page above the
  /// table.
  std::vector<std::string> findings = {};
};

/// Tables with their explanations, put together once and written as Markdown and LaTeX.
struct Document {
  std::string key;  ///< short name, such as that of the data set
  std::string title;
  std::vector<std::string> paragraphs = {};  ///< valid for all tables
  std::vector<Section> sections = {};
};

/// Returns Markdown with lines of at most 100 characters, except for long titles and words. A wider
/// table is split into several (text/table.hpp).
std::string markdown(const Document& document);

/// Returns LaTeX for \input: the paragraphs and a float for each table, labelled
/// tab:<document>-<section>. A comment at the beginning names the packages that it needs.
std::string latex(const Document& document);

}  // namespace piae::report
