#include "report/published.hpp"

#include <functional>
#include <span>

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "report/paper.hpp"
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

/// Reads a table with a method in each row and a ratio in each column from the third on.
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
    if (!runs.empty()) line.refuse("names dataset " + line.fields[0] + " again");
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

}  // namespace piae::report
