#pragma once

#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "report/paper_reference.hpp"

namespace piae::report {

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
