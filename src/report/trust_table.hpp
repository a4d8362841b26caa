#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/trust.hpp"
#include "report/document.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// Reliability of the kept classifiers of one method, ratio and classifier, over the seeds.
struct TrustRow {
  run::Combination combination;
  scoring::Summary accuracy;  ///< this and the next three: see diagnosis::Trust, in percent
  scoring::Summary raw_calibration_error;
  scoring::Summary calibration_error;
  scoring::Summary called_unknown;
  scoring::Summary temperature;
  /// Numbers for a class left out of training, as means over the classes: how well its windows are
  /// separated from the others, in [0, 1], and the share called unknown, in percent. Empty if the
  /// classifier does not measure novelty (KeptClassifier::novelty()).
  std::optional<scoring::Summary> auroc = {};
  std::optional<scoring::Summary> untrained_called_unknown = {};
  /// The area of each class, by its name.
  std::vector<std::pair<std::string, scoring::Summary>> auroc_by_class = {};
};

/// Reads the kept classifier of every cell. Throws artefact::Refusal if one is missing or belongs
/// to another cell.
std::vector<TrustRow> trust_rows(const run::Layout& layout, const run::Grid& grid);

/// Returns a line for each quantity of each row, and one for each class left out of training:
/// dataset,classifier,method,ratio,seeds,quantity,class,mean,std.
std::string trust_csv(const std::string& dataset, const std::vector<TrustRow>& rows);

Document trust_document(const std::string& dataset, const std::vector<TrustRow>& rows);

}  // namespace piae::report
