#include "report/paper_methods.hpp"

#include <algorithm>
#include <iterator>

namespace piae::report {

namespace {

/// Whether it is the paper's method or an ablation of it.
bool is_model(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && (entry->model > 0 || augment::is_ablation(*entry));
}

bool is_ablation(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && augment::is_ablation(*entry);
}

}  // namespace

std::vector<augment::CatalogueEntry> all_models() {
  std::vector<augment::CatalogueEntry> models;
  std::ranges::copy_if(augment::catalogue(), std::back_inserter(models),
                       [](const augment::CatalogueEntry& entry) { return entry.model > 0; });
  return models;
}

std::vector<MethodGroup> method_groups(const std::vector<std::string>& methods) {
  MethodGroup compared{.key = "methods",
                       .name = "the methods",
                       .methods = {},
                       .are_models = false,
                       .table = &PaperDataset::methods_table,
                       .quality_figure = &PaperDataset::methods_quality_figure,
                       .gain_figure = 15};
  MethodGroup models{.key = "ablation",
                     .name = "the ablations",
                     .methods = {},
                     .are_models = true,
                     .table = &PaperDataset::ablation_table,
                     .quality_figure = &PaperDataset::ablation_quality_figure,
                     .gain_figure = 18};
  std::ranges::remove_copy_if(methods, std::back_inserter(compared.methods), is_ablation);
  std::ranges::copy_if(methods, std::back_inserter(models.methods), is_model);
  std::vector<MethodGroup> groups;
  if (!compared.methods.empty()) groups.push_back(compared);
  if (std::ranges::any_of(methods, is_ablation)) groups.push_back(models);
  return groups;
}

}  // namespace piae::report
