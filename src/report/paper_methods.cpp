#include "report/paper_methods.hpp"

#include <algorithm>
#include <iterator>

namespace piae::report {

namespace {

constexpr Model models[] = {{1, "piae-dt", "the full model"},
                            {2, "ae", "without the physics"},
                            {3, "physics", "without the auto-encoder"},
                            {4, "piae-dt-cnn", "with a convolutional auto-encoder"},
                            {5, "piae-dt-rnn", "with a recurrent auto-encoder"}};

bool is_ablation(const std::string& method) {
  const Model* model = find_model(method);
  return model != nullptr && model->number > 1;
}

}  // namespace

std::span<const Model> all_models() { return models; }

const Model* find_model(const std::string& method) {
  const auto* const found = std::ranges::find(models, method, &Model::method);
  return found == std::end(models) ? nullptr : found;
}

std::vector<MethodGroup> method_groups(const std::vector<std::string>& methods) {
  const auto is_model = [](const std::string& method) { return find_model(method) != nullptr; };
  MethodGroup compared{"methods",
                       "the methods",
                       {},
                       false,
                       &PaperDataset::methods_table,
                       &PaperDataset::methods_quality_figure,
                       15};
  MethodGroup models{"ablation",
                     "the ablations",
                     {},
                     true,
                     &PaperDataset::ablation_table,
                     &PaperDataset::ablation_quality_figure,
                     18};
  std::ranges::remove_copy_if(methods, std::back_inserter(compared.methods), is_ablation);
  std::ranges::copy_if(methods, std::back_inserter(models.methods), is_model);
  std::vector<MethodGroup> groups;
  if (!compared.methods.empty()) groups.push_back(compared);
  if (std::ranges::any_of(methods, is_ablation)) groups.push_back(models);
  return groups;
}

}  // namespace piae::report
