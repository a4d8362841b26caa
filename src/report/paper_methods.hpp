#pragma once

#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "report/counterpart.hpp"

namespace piae::report {

/// The paper's five models, Model 1 being piae-dt itself (Section 4.5.4, Tables 10 and 11).
std::vector<augment::CatalogueEntry> all_models();

/// Methods that share tables.
struct MethodGroup {
  std::string key;   ///< short name: "methods"
  std::string name;  ///< "the methods"
  std::vector<std::string> methods;
  bool are_models;                    ///< all of them are one of the five
  int PaperDataset::*table;           ///< the paper's, with their accuracies
  int PaperDataset::*quality_figure;  ///< the paper's, with their MMD and RMSE
  int gain_figure;                    ///< the paper's, with the gains on both datasets
};

/// These methods by the paper's tables, in the same order: those compared in Tables 8 and 9, which
/// are all but the ablations, Models 2 to 5; and where there is an ablation, those of Tables 10 and
/// 11, which are all five models. No group is empty.
std::vector<MethodGroup> method_groups(const std::vector<std::string>& methods);

}  // namespace piae::report
