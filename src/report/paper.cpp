#include "report/paper.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <utility>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "run/grid.hpp"
#include "scoring/ratios.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

namespace fs = std::filesystem;

double percent_of(const text::CsvLine& line, std::size_t i) {
  const std::optional<double> value = line.number(i);
  if (!value || *value < 0 || *value > 100) {
    line.refuse("'" + line.fields[i] + "' is not a percentage");
  }
  return *value;
}

void require_header(const text::CsvLine& header, std::size_t i, const std::string& word) {
  if (i >= header.fields.size() || header.fields[i] != word) {
    header.refuse("field " + std::to_string(i + 1) + " of the header must be '" + word + "'");
  }
}

void require_ratio(const text::CsvLine& header, const std::string& name) {
  try {
    scoring::find_ratio(name);
  } catch (const Error& error) {
    header.refuse(error.what());
  }
}

std::string method_of_model(const text::CsvLine& line) {
  for (const augment::CatalogueEntry& model : all_models()) {
    if (line.fields[1] == "model" + std::to_string(model.model)) return model.name;
  }
  line.refuse("unknown model '" + line.fields[1] + "'; known are model1 to model5");
}

using Percents = std::map<std::tuple<std::string, std::string, std::string>, PublishedPercent>;

void add(Percents& percents, const text::CsvLine& line, const std::string& method,
         const std::string& ratio, double percent) {
  const auto [known, is_new] =
      percents.try_emplace({line.fields[0], method, ratio}, PublishedPercent{percent, line.place});
  if (!is_new && known->second.value != percent) {
    line.refuse("contradicts the figure for " + method + " at " + ratio + " in " +
                known->second.place);
  }
}

/// Reads a table with a method in each row and, from the third column on, a ratio in each column.
void read_by_ratio(const fs::path& path, const std::string& second_column,
                   const std::function<std::string(const text::CsvLine&)>& method_of,
                   Percents& percents) {
  const std::vector<text::CsvLine> lines = text::read_csv(path);
  const text::CsvLine& header = lines.front();
  require_header(header, 0, "dataset");
  require_header(header, 1, second_column);
  for (std::size_t i = 2; i < header.fields.size(); ++i) require_ratio(header, header.fields[i]);
  for (const text::CsvLine& line : std::span(lines).subspan(1)) {
    for (std::size_t i = 2; i < line.fields.size(); ++i) {
      add(percents, line, method_of(line), header.fields[i], percent_of(line, i));
    }
  }
}

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
      "HFHP, the paper's second dataset, is private; hit-sm stands in for it. The paper's values "
      "for HFHP are shown for orientation only: the rig and the defects differ, so nothing here "
      "can agree or disagree with them."}},
    {"cwru-as-published",
     {cwru, false, "is CWRU with its sample rates mixed",
      "Here the healthy record, which was made at 48 kHz, is treated as one of 12 kHz. It is not "
      "known if the paper did so, so its values for CWRU are shown for orientation only."}},
};

std::optional<Counterpart> counterpart_of(const std::string& dataset) {
  for (const auto& [name, counterpart] : counterparts) {
    if (dataset == name) return counterpart;
  }
  return std::nullopt;
}

/// True for the paper's method and its ablations.
bool is_model(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && (entry->model > 0 || augment::is_ablation(*entry));
}

bool is_ablation(const std::string& method) {
  const augment::CatalogueEntry* const entry = augment::find_entry(method);
  return entry != nullptr && augment::is_ablation(*entry);
}

}  // namespace

Published::Published(const fs::path& folder) {
  const std::vector<text::CsvLine> lines = text::read_csv(folder / "table6-7-baseline.csv");
  const std::size_t average = lines.front().fields.size() - 1;
  require_header(lines.front(), 0, "dataset");
  for (std::size_t i = 1; i < average; ++i) {
    require_header(lines.front(), i, "run" + std::to_string(i));
  }
  require_header(lines.front(), average, "average");
  for (const text::CsvLine& line : std::span(lines).subspan(1)) {
    std::vector<double>& runs = baseline_runs_[line.fields[0]];
    if (!runs.empty()) line.refuse("names data set " + line.fields[0] + " again");
    for (std::size_t i = 1; i < average; ++i) runs.push_back(percent_of(line, i));
    add(percents_, line, augment::no_method, scoring::all_ratios().front().name,
        percent_of(line, average));
  }
  read_by_ratio(
      folder / "table8-9-methods.csv", "method",
      [](const text::CsvLine& line) { return line.fields[1]; }, percents_);
  read_by_ratio(folder / "table10-11-ablation.csv", "model", method_of_model, percents_);
}

std::optional<double> Published::percent(const std::string& dataset, const std::string& method,
                                         const std::string& ratio) const {
  const auto found = percents_.find({dataset, method, ratio});
  if (found == percents_.end()) return std::nullopt;
  return found->second.value;
}

std::vector<double> Published::baseline_runs(const std::string& dataset) const {
  const auto found = baseline_runs_.find(dataset);
  return found == baseline_runs_.end() ? std::vector<double>{} : found->second;
}

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
  return {.before_note = "Replaces the paper's " + what + "; " + dataset_ + " " +
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
