#pragma once

#include <optional>
#include <string>

namespace piae::report {

/// One of the two datasets of the paper, and the numbers of the tables and figures that show it.
struct PaperDataset {
  const char* name;   ///< as ours is called: "hfhp"
  const char* title;  ///< as the paper writes it: "HFHP"
  int baseline_table;
  int methods_table;
  int ablation_table;
  int methods_quality_figure;
  int ablation_quality_figure;
};

/// The dataset of the paper that one of ours is shown beside.
struct Counterpart {
  PaperDataset paper;
  /// Whether both are the same recordings. Otherwise the published figures are of other recordings;
  /// they are for orientation only, and must be shown as such.
  bool own;
  const char* relation;  ///< where not its own, what ours is: "stands in for HFHP"
  const char* caution;   ///< where not its own, how to read the figures, in sentences
};

/// What tables of a dataset say of the paper.
class PaperReference {
 public:
  explicit PaperReference(std::string dataset);

  [[nodiscard]] const std::string& dataset() const { return dataset_; }
  /// Empty for a dataset that has no counterpart in the paper.
  [[nodiscard]] const std::optional<Counterpart>& beside() const { return counterpart_; }

  /// Ends the title of a table that the paper does not have: " (hit-sm stands in for HFHP)".
  /// Nothing for a dataset of the paper, or without a counterpart.
  [[nodiscard]] std::string none() const;
  /// End the title of a table that the paper has, too. The number is given as a member of
  /// PaperDataset: " (the paper's Table 8)", " (in the place of the paper's Table 9; hit-sm stands
  /// in for HFHP)". Nothing for a dataset without a counterpart.
  [[nodiscard]] std::string table(int PaperDataset::*number) const;
  [[nodiscard]] std::string figure(int PaperDataset::*number) const;
  /// The same for a figure that shows both datasets.
  [[nodiscard]] std::string figure(int number) const;
  /// Stands before published numbers: "paper", "paper, HFHP".
  [[nodiscard]] std::string label() const;

 private:
  [[nodiscard]] std::string brackets(const std::string& what) const;

  std::string dataset_;
  std::optional<Counterpart> counterpart_;
};

}  // namespace piae::report
