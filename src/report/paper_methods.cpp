#include "report/paper_methods.hpp"

#include <algorithm>
#include <iterator>

namespace piae::report {

namespace {

bool is_model(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && entry->model > 0;
}

bool is_ablation(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && entry->kind == augment::Kind::ablation;
}

}  // namespace

std::vector<augment::CatalogueEntry> all_models() {
  std::vector<augment::CatalogueEntry> models;
  std::ranges::copy_if(augment::catalogue(), std::back_inserter(models),
                       [](const augment::CatalogueEntry& entry) { return entry.model > 0; });
  return models;
}

const std::string& paper_method() {
  static const std::string name =
      std::ranges::find(augment::catalogue(), 1, &augment::CatalogueEntry::model)->name;
  return name;
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
