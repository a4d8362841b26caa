#include "page/results_view.hpp"

#include "page/table.hpp"
#include "report/accuracy_table.hpp"
#include "report/decisions_table.hpp"
#include "report/paper.hpp"
#include "report/recall_table.hpp"
#include "report/recommendation_tables.hpp"

namespace piae::page {

namespace {

using Sections = std::vector<report::Section>;

Html no_diagnosis() { return element("p", "There is no diagnosis yet."); }

/// Places tables next to each other if the window is wide enough.
Html beside_each_other(const Sections& sections) {
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
  for (const report::ClassifierRows& block : report::by_classifier(contents.rows)) {
    view += beside_each_other(report::ratio_sections(block, contents.grid.seeds.size()));
  }
  return view;
}

Html recall_view(const DatasetContents& contents) {
  const Sections sections = report::recall_sections(contents.rows, contents.results);
  return sections.empty() ? no_diagnosis() : html(sections.front());
}

Html decisions_view(const DatasetContents& contents) {
  if (contents.rows.empty()) return no_diagnosis();
  Html view;
  const std::string gap = report::decisions_gap(contents.results);
  if (!gap.empty()) view += element("p", gap);
  for (const report::ClassifierRows& block : report::by_classifier(contents.rows)) {
    Sections sections = report::decision_sections(block, contents.results);
    for (report::Section& each : report::confidence_sections(block, contents.results)) {
      sections.push_back(std::move(each));
    }
    for (report::Section& section : sections) section.title += ", by " + block.classifier;
    view += beside_each_other(sections);
  }
  return view;
}

Html recommendation_view(const DatasetContents& contents) {
  const Sections sections = report::recommendation_sections(contents.recommendations);
  if (sections.empty()) return no_diagnosis();
  return sentences_view(sections.front().findings) + beside_each_other(sections);
}

}  // namespace piae::page
