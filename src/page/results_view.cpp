#include "page/results_view.hpp"

#include "page/table.hpp"
#include "report/paper.hpp"

namespace piae::page {

namespace {

using Sections = std::vector<report::Section>;

Html no_diagnosis() { return element("p", "No diagnosis has finished yet."); }

/// Places tables next to each other if the window is wide enough.
Html side_by_side(const Sections& sections) {
  Html tables;
  for (const report::Section& section : sections) tables += element("div", html(section));
  return element("div", {{"class", "pair"}}, tables);
}

/// Returns a paragraph for each sentence; the first stands out.
Html sentences_view(const std::vector<std::string>& sentences) {
  Html view;
  for (const std::string& sentence : sentences) {
    view += view.empty() ? element("p", {{"class", "verdict"}}, sentence) : element("p", sentence);
  }
  return view;
}

}  // namespace

Html accuracy_view(const DatasetContents& contents) {
  const report::PaperReference reference(contents.name);
  Html view;
  for (const std::string& sentence : contents.verdict) {
    view += element("p", {{"class", "verdict"}}, sentence);
  }
  if (reference.counterpart() && !reference.counterpart()->own) {
    view += element("p", reference.counterpart()->caution);
  }
  if (contents.rows.empty()) return view + no_diagnosis();
  for (const Sections& sections : contents.tables.accuracy) view += side_by_side(sections);
  return view;
}

Html recall_view(const DatasetContents& contents) {
  const Sections& recall = contents.tables.recall;
  return recall.empty() ? no_diagnosis() : html(recall.front());
}

Html decisions_view(const DatasetContents& contents) {
  if (contents.rows.empty()) return no_diagnosis();
  Html view;
  const std::string& gap = contents.tables.decisions_gap;
  if (!gap.empty()) view += element("p", gap);
  for (const Sections& sections : contents.tables.decisions) view += side_by_side(sections);
  return view;
}

Html recommendation_view(const DatasetContents& contents) {
  const Sections& sections = contents.tables.recommendation;
  if (sections.empty()) return no_diagnosis();
  return sentences_view(sections.front().findings) + side_by_side(sections);
}

}  // namespace piae::page
