#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "report/recommendation.hpp"
#include "run/collect.hpp"

namespace piae::report {

/// Tables of one data set in the report, as data. Lists are empty without a diagnosis.
struct ReportTables {
  using Sections = std::vector<Section>;

  Sections overview = {};                ///< one for each classifier
  std::vector<Sections> accuracy = {};   ///< for each classifier: ratio_sections()
  Sections recall = {};                  ///< none or one
  std::string decisions_gap = {};        ///< reason for missing decisions; see decisions_gap()
  std::vector<Sections> decisions = {};  ///< for each classifier: decisions and confidence
  Sections recommendation = {};
};

/// Returns the tables of these results. `seeds` is the number of seeds in the grid.
ReportTables report_tables(const std::vector<AccuracyRow>& rows, const run::Results& results,
                           const std::vector<Recommendation>& recommendations, std::size_t seeds);

}  // namespace piae::report
