#include "report/report_tables.hpp"

#include <iterator>

#include "diagnosis/catalogue.hpp"
#include "report/accuracy_table.hpp"
#include "report/decisions_table.hpp"
#include "report/recall_table.hpp"
#include "report/recommendation_tables.hpp"
#include "report/summary.hpp"

namespace piae::report {

namespace {

std::vector<Section> decisions_by(const ClassifierRows& block, const run::Results& results) {
  std::vector<Section> sections = decision_sections(block, results);
  std::ranges::move(confidence_sections(block, results), std::back_inserter(sections));
  for (Section& section : sections)
    section.title += ", by " + diagnosis::marked_name(block.classifier);
  return sections;
}

}  // namespace

ReportTables report_tables(const std::vector<AccuracyRow>& rows, const run::Results& results,
                           const std::vector<Recommendation>& recommendations, std::size_t seeds) {
  ReportTables tables;
  if (rows.empty()) return tables;
  tables.overview = overview_sections(rows, seeds);
  tables.recall = recall_sections(rows, results);
  tables.decisions_gap = decisions_gap(results);
  tables.recommendation = recommendation_sections(recommendations);
  for (const ClassifierRows& block : by_classifier(rows)) {
    tables.accuracy.push_back(ratio_sections(block, seeds));
    tables.decisions.push_back(decisions_by(block, results));
  }
  return tables;
}

}  // namespace piae::report
