#pragma once

#include <string>
#include <vector>

#include "text/table.hpp"

namespace piae::report {

/// A table with what must be said of it. All texts are plain ones.
struct Section {
  std::string key;    ///< short name, such as "accuracy-methods"
  std::string title;  ///< without a full stop
  std::string note;   ///< one paragraph of sentences; empty where nothing is to be said
  text::Table table;
};

/// The tables of a dataset, written once and rendered in several ways.
struct Document {
  std::string key;  ///< short name, the dataset
  std::string title;
  std::vector<std::string> paragraphs;  ///< what holds for all tables
  std::vector<Section> sections;
};

std::string markdown(const Document& document);

/// For \input: the paragraphs, and a float for each table with the label tab:<document>-<section>.
/// A comment at the beginning names the packages that it needs.
std::string latex(const Document& document);

}  // namespace piae::report
