#include "report/paper.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace piae::report {

namespace {

constexpr PaperDataset cwru{.name = "cwru",
                            .title = "CWRU",
                            .baseline_table = 6,
                            .methods_table = 8,
                            .ablation_table = 10,
                            .methods_quality_figure = 13,
                            .ablation_quality_figure = 16};
constexpr PaperDataset hfhp{.name = "hfhp",
                            .title = "HFHP",
                            .baseline_table = 7,
                            .methods_table = 9,
                            .ablation_table = 11,
                            .methods_quality_figure = 14,
                            .ablation_quality_figure = 17};

const std::pair<const char*, Counterpart> counterparts[] = {
    {"cwru", {cwru, true, "", ""}},
    {"hfhp", {hfhp, true, "", ""}},
    {"hit-sm",
     {hfhp, false, "stands in for HFHP",
      "HFHP, the paper's second dataset, is private; hit-sm stands in for it. What the paper "
      "publishes of HFHP is shown for orientation only: it is of another rig, of other defects, "
      "and nothing here can agree or disagree with it."}},
    {"cwru-as-published",
     {cwru, false, "is CWRU with its sample rates mixed",
      "Here the healthy record, which was made at 48 kHz, is taken for one of 12 kHz. Whether the "
      "paper did so is not known: what it publishes of CWRU is shown for orientation only."}},
};

std::optional<Counterpart> counterpart_of(const std::string& dataset) {
  for (const auto& [name, counterpart] : counterparts) {
    if (dataset == name) return counterpart;
  }
  return std::nullopt;
}

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

PaperReference::PaperReference(std::string dataset, const std::string& classifier)
    : dataset_(std::move(dataset)) {
  if (classifier == scoring::paper_classifier) counterpart_ = counterpart_of(dataset_);
}

Section Place::of(Section section) const {
  section.title += after_title;
  if (!section.findings.empty()) {
    if (!before_note.empty()) section.findings.insert(section.findings.begin(), before_note);
    return section;
  }
  const bool both = !before_note.empty() && !section.note.empty();
  section.note = before_note + (both ? " " : "") + section.note;
  return section;
}

Place PaperReference::none() const {
  if (!counterpart_ || counterpart_->own) return {};
  return {.before_note = dataset_ + " " + counterpart_->relation + "."};
}

Place PaperReference::table(int PaperDataset::*number) const {
  return counterpart_ ? place_of("Table " + std::to_string(counterpart_->paper.*number)) : Place{};
}

Place PaperReference::figure(int PaperDataset::*number) const {
  return counterpart_ ? figure(counterpart_->paper.*number) : Place{};
}

Place PaperReference::figure(int number) const {
  return counterpart_ ? place_of("Fig. " + std::to_string(number)) : Place{};
}

std::string PaperReference::label() const {
  if (!counterpart_ || counterpart_->own) return "paper";
  return std::string("paper, ") + counterpart_->paper.title;
}

Place PaperReference::place_of(const std::string& what) const {
  if (counterpart_->own) return {.after_title = " (the paper's " + what + ")"};
  return {.before_note = "In the place of the paper's " + what + "; " + dataset_ + " " +
                         counterpart_->relation + "."};
}

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
