#pragma once

#include <string>
#include <vector>

#include "figures/stored_source.hpp"

namespace piae::figures {

/// Diagnoses of a few test windows with given true and predicted classes.
class DiagnosedWindows : public StoredSource {
 protected:
  [[nodiscard]] scoring::DiagnosisRecord record_of(const std::string& method,
                                                   const std::string& ratio, int generated,
                                                   int seed, const std::vector<Label>& labels,
                                                   const std::vector<Label>& predictions) const {
    scoring::DiagnosisRecord record = diagnosis(method, ratio, generated, seed, 0);
    record.labels = labels;
    record.predictions = predictions;
    record.scores.assign(3 * labels.size(), 0);
    return record;
  }
  /// Adds vae at 2to1: over both seeds one of four healthy windows is predicted as IR, and one of
  /// four IR windows as healthy; in seed 0 one of two OR windows is predicted as IR. At 10to1 all
  /// predictions are wrong.
  void add_two_seeds() const {
    const std::vector<Label> truth{0, 0, 1, 1, 2, 2};
    add(record_of("vae", "2to1", 145, 0, truth, {0, 0, 1, 0, 2, 1}));
    add(record_of("vae", "2to1", 145, 1, truth, {0, 1, 1, 1, 2, 2}));
    for (const int seed : {0, 1})
      add(record_of("vae", "10to1", 45, seed, truth, {1, 1, 0, 0, 0, 0}));
  }
};

}  // namespace piae::figures
