#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "augment/catalogue.hpp"
#include "report/document.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::report {

struct PublishedPercent {
  double value = 0;
  std::string place;  ///< file and line
};

/// Accuracies that the paper publishes, in percent.
class Published {
 public:
  /// Without any accuracies.
  Published() = default;
  /// Reads table6-7-baseline.csv, table8-9-methods.csv and table10-11-ablation.csv of a folder.
  /// Throws Error(input_missing) for a file that cannot be read, and Error(bad_input) with file and
  /// line for an unknown header, model or ratio, a row of another length than the header, a value
  /// that is no percentage, and one that contradicts another table.
  explicit Published(const std::filesystem::path& folder);

  /// Empty where the paper has no such dataset, method or ratio.
  [[nodiscard]] std::optional<double> percent(const std::string& dataset, const std::string& method,
                                              const std::string& ratio) const;
  /// The runs of Tables 6 and 7, without augmentation. Empty for any other dataset.
  [[nodiscard]] std::vector<double> baseline_runs(const std::string& dataset) const;

 private:
  /// By data set, method and ratio.
  std::map<std::tuple<std::string, std::string, std::string>, PublishedPercent> percents_;
  std::map<std::string, std::vector<double>> baseline_runs_;
};

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

/// What a table says of its counterpart in the paper.
struct Place {
  std::string after_title = {};  ///< " (the paper's Table 8)"; short, since a heading is one line
  std::string before_note = {};  ///< a sentence

  /// The section, with this said of it.
  [[nodiscard]] Section of(Section section) const;
};

/// What tables of a dataset say of the paper, which has none by another classifier than its own.
class PaperReference {
 public:
  explicit PaperReference(std::string dataset,
                          const std::string& classifier = scoring::paper_classifier);

  [[nodiscard]] const std::string& dataset() const { return dataset_; }
  /// Empty for a dataset that has no counterpart in the paper.
  [[nodiscard]] const std::optional<Counterpart>& beside() const { return counterpart_; }

  /// Of a table that the paper does not have: "hit-sm stands in for HFHP." Nothing for a dataset of
  /// the paper, or without a counterpart.
  [[nodiscard]] Place none() const;
  /// Of a table that the paper has, too. The number is given as a member of PaperDataset. For a
  /// dataset of the paper it stands after the title; for one with another counterpart before the
  /// note: "In the place of the paper's Table 9; hit-sm stands in for HFHP."
  [[nodiscard]] Place table(int PaperDataset::*number) const;
  [[nodiscard]] Place figure(int PaperDataset::*number) const;
  /// The same for a figure that shows both datasets.
  [[nodiscard]] Place figure(int number) const;
  /// Stands before published numbers: "paper", "paper, HFHP".
  [[nodiscard]] std::string label() const;

 private:
  [[nodiscard]] Place place_of(const std::string& what) const;

  std::string dataset_;
  std::optional<Counterpart> counterpart_;
};

/// The paper's five models (Section 4.5.4, Tables 10 and 11), in the order of their numbers.
std::vector<augment::CatalogueEntry> all_models();

/// Methods that are shown in the same tables.
struct MethodGroup {
  std::string key;   ///< short name: "methods"
  std::string name;  ///< "the methods"
  std::vector<std::string> methods;
  bool are_models;           ///< whether the tables name them by the numbers of the models,
                             ///< where they have one
  int PaperDataset::*table;  ///< the paper's table of their accuracies
  int PaperDataset::*quality_figure;  ///< the paper's figure of their MMD and RMSE
  int gain_figure;                    ///< the paper's figure of their gains on both datasets
};

/// The groups that these methods form in the paper's tables, none of them empty, methods in the
/// order given. The first are those that Tables 8 and 9 compare, which are all but the ablations
/// (Models 2 to 5 and those of the outlook). The second are all models, as in Tables 10 and 11, and
/// the ablations of the outlook, where any ablation is given.
std::vector<MethodGroup> method_groups(const std::vector<std::string>& methods);

}  // namespace piae::report
