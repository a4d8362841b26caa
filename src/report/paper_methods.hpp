#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/counterpart.hpp"

namespace piae::report {

/// One of the paper's five models (Section 4.5.4, Tables 10 and 11).
struct Model {
  int number;
  const char* method;  ///< its name in the grid
  const char* what;
};

/// Model 1, which is piae-dt itself, to Model 5.
std::span<const Model> all_models();
/// Null for a method that is none of them.
const Model* find_model(const std::string& method);

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
