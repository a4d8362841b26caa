#pragma once

#include <optional>
#include <string>
#include <utility>

#include "report/counterpart.hpp"

namespace piae::report {

/// How tables of a dataset refer to the paper.
class PaperReference {
 public:
  explicit PaperReference(std::string dataset)
      : dataset_(std::move(dataset)), counterpart_(counterpart(dataset_)) {}

  [[nodiscard]] const std::string& dataset() const { return dataset_; }
  /// Empty for a dataset that has no counterpart in the paper.
  [[nodiscard]] const std::optional<Counterpart>& beside() const { return counterpart_; }

  /// What follows a title of what the paper does not show: " (hit-sm stands in for HFHP)", or
  /// nothing for its own dataset.
  [[nodiscard]] std::string none() const;
  /// What follows a title, with the table's or the figure's number as a member of PaperDataset:
  /// " (the paper's Table 8)", " (in the place of the paper's Table 9; hit-sm stands in for HFHP)".
  [[nodiscard]] std::string table(int PaperDataset::*number) const;
  [[nodiscard]] std::string figure(int PaperDataset::*number) const;
  /// The same for a figure that shows both datasets.
  [[nodiscard]] std::string figure(int number) const;
  /// Before published figures: "paper", "paper, HFHP".
  [[nodiscard]] std::string label() const;

 private:
  [[nodiscard]] std::string brackets(const std::string& what) const;

  std::string dataset_;
  std::optional<Counterpart> counterpart_;
};

}  // namespace piae::report
