#pragma once

#include <optional>
#include <string>

namespace piae::report {

/// What the paper shows of one of its two datasets: numbers of its tables and figures.
struct PaperDataset {
  const char* name;   ///< as ours is called: "hfhp"
  const char* title;  ///< as the paper writes it: "HFHP"
  int baseline_table;
  int methods_table;
  int ablation_table;
  int methods_quality_figure;
  int ablation_quality_figure;
};

/// What of the paper a dataset is set beside.
struct Counterpart {
  PaperDataset paper;
  /// Whether the dataset is the paper's own. Otherwise the published figures are those of another
  /// one, for orientation only, and must be shown as such.
  bool own;
  const char* relation;  ///< where not its own, what it is: "stands in for HFHP"
  const char* caution;   ///< where not its own, sentences on how to read its figures
};

/// Empty for a dataset that resembles none of the paper's.
std::optional<Counterpart> counterpart(const std::string& dataset);

}  // namespace piae::report
