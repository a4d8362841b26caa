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

/// Published accuracies of the paper, in percent.
class Published {
 public:
  /// Holds no accuracies.
  Published() = default;
  /// Reads table6-7-baseline.csv, table8-9-methods.csv and table10-11-ablation.csv of a folder.
  /// Throws Error(input_missing) if a file cannot be read. Throws Error(bad_input) with file and
  /// line for an unknown header, model or ratio; for a row of another length than the header; and
  /// for a value that is not a percentage or contradicts another table.
  explicit Published(const std::filesystem::path& folder);

  /// Returns nothing if the paper does not have the dataset, method or ratio.
  [[nodiscard]] std::optional<double> percent(const std::string& dataset, const std::string& method,
                                              const std::string& ratio) const;
  /// Returns the runs of Tables 6 and 7, without augmentation; none for other data sets.
  [[nodiscard]] std::vector<double> baseline_runs(const std::string& dataset) const;

 private:
  /// By dataset, method and ratio.
  std::map<std::tuple<std::string, std::string, std::string>, PublishedPercent> percents_;
  std::map<std::string, std::vector<double>> baseline_runs_;
};

/// A data set of the paper, with the numbers of its tables and figures.
struct PaperDataset {
  const char* name;   ///< name of the same data set here: "hfhp"
  const char* title;  ///< name in the paper: "HFHP"
  int baseline_table;
  int methods_table;
  int ablation_table;
  int methods_quality_figure;
  int ablation_quality_figure;
};

/// Dataset of the paper that is shown next to one of ours.
struct Counterpart {
  PaperDataset paper;
  /// True if both are the same recordings. Otherwise the published numbers are for orientation only
  /// and must be shown as such.
  bool own;
  const char* relation;  ///< what our data set is, if not the same: "stands in for HFHP"
  const char* caution;   ///< how to read the numbers, if not the same; sentences
};

/// Words that a table adds about its counterpart in the paper.
struct Place {
  std::string after_title = {};  ///< " (the paper's Table 8)"; short, because a heading is one line
  std::string before_note = {};  ///< a sentence

  /// Returns the section with these words added.
  [[nodiscard]] Section of(Section section) const;
};

/// References of a data set's tables to the paper. Empty for classifiers that the paper does not
/// have.
class PaperReference {
 public:
  explicit PaperReference(std::string dataset,
                          const std::string& classifier = scoring::paper_classifier);

  [[nodiscard]] const std::string& dataset() const { return dataset_; }
  /// Returns nothing for a data set without a counterpart in the paper.
  [[nodiscard]] const std::optional<Counterpart>& counterpart() const { return counterpart_; }

  /// Returns the words for a table that the paper does not have: "hit-sm stands in for HFHP." Empty
  /// for a data set of the paper or without a counterpart.
  [[nodiscard]] Place none() const;
  /// Returns the words for a table that the paper also has; `number` is a member of PaperDataset. A
  /// data set of the paper gets them after the title. Another gets them before the note: "In the
  /// place of the paper's Table 9; hit-sm stands in for HFHP."
  [[nodiscard]] Place table(int PaperDataset::*number) const;
  [[nodiscard]] Place figure(int PaperDataset::*number) const;
  /// The same for a figure that shows both data sets.
  [[nodiscard]] Place figure(int number) const;
  /// Returns the heading of published numbers: "paper" or "paper, HFHP".
  [[nodiscard]] std::string label() const;

 private:
  [[nodiscard]] Place place_of(const std::string& what) const;

  std::string dataset_;
  std::optional<Counterpart> counterpart_;
};

/// Returns the paper's five models (Section 4.5.4, Tables 10 and 11), in the order of their
/// numbers.
std::vector<augment::CatalogueEntry> all_models();

/// Methods that are shown in the same tables.
struct MethodGroup {
  std::string key;   ///< short name: "methods"
  std::string name;  ///< "the methods"
  std::vector<std::string> methods;
  bool are_models;  ///< true if the tables name methods by the number of their model, if any
  int PaperDataset::*table;           ///< the paper's table of the methods' accuracies
  int PaperDataset::*quality_figure;  ///< the paper's figure of the methods' MMD and RMSE
  int gain_figure;  ///< the paper's figure of the methods' gains on both data sets
};

/// Returns the groups of these methods in the paper's tables, in the given order, without empty
/// groups. The first group is compared in Tables 8 and 9: all but the ablations (Models 2 to 5 and
/// the ablations of the outlook). The second group is all models, as in Tables 10 and 11, and the
/// ablations of the outlook; it exists only if `methods` has an ablation.
std::vector<MethodGroup> method_groups(const std::vector<std::string>& methods);

}  // namespace piae::report
