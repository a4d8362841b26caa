#include "report/twin_table.hpp"

#include <array>
#include <functional>

#include "report/labels.hpp"
#include "scoring/statistics.hpp"
#include "twin/outcome.hpp"

namespace piae::report {

namespace {

using twin::Outcome;

/// Returns the outcomes of one method's trainings, by seed.
std::vector<Outcome> outcomes_of(const std::string& method, const run::Layout& layout,
                                 const run::Held& held) {
  std::vector<std::filesystem::path> files;
  for (const std::int64_t seed : held.seeds()) {
    const auto file = layout.model(method, seed);
    if (held.has(file)) files.push_back(file);
  }
  artefact::Readers models(files, "model");
  std::vector<Outcome> outcomes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const artefact::Reader model = models.next();
    if (twin::has_outcome(model)) outcomes.push_back(twin::read_outcome(model));
  }
  return outcomes;
}

struct Column {
  const char* heading;
  int decimals;
  double (*value)(const Outcome&);
};

double share_of_open(const Outcome& outcome) {
  return 100.0 * static_cast<double>(outcome.open_contacts) /
         static_cast<double>(outcome.states.size());
}

constexpr std::array<Column, 10> columns{{
    {"L_DDL", 3, [](const Outcome& o) { return o.differential.loss; }},
    {"L_DT", 3, [](const Outcome& o) { return o.twin.loss; }},
    {"L_Rec", 3, [](const Outcome& o) { return o.reconstruction.loss; }},
    {"α", 2, [](const Outcome& o) { return o.differential.weight; }},
    {"2αL", 2, [](const Outcome& o) { return o.differential.of_stationary(); }},
    {"β", 2, [](const Outcome& o) { return o.twin.weight; }},
    {"2βL", 2, [](const Outcome& o) { return o.twin.of_stationary(); }},
    {"γ", 2, [](const Outcome& o) { return o.reconstruction.weight; }},
    {"2γL", 2, [](const Outcome& o) { return o.reconstruction.of_stationary(); }},
    {"open, %", 0, share_of_open},
}};

}  // namespace

std::vector<Section> twin_sections(const run::Layout& layout, const run::Grid& grid,
                                   const run::Held& held) {
  std::vector<std::string> header{"method"};
  for (const Column& column : columns) header.emplace_back(column.heading);
  text::Table table(header, 1);
  bool any = false;
  for (const std::string& method : grid.scored) {
    const std::vector<Outcome> outcomes = outcomes_of(method, layout, held);
    if (outcomes.empty()) continue;
    any = true;
    std::vector<std::string> cells{method};
    for (const Column& column : columns) {
      std::vector<double> values;
      values.reserve(outcomes.size());
      for (const Outcome& outcome : outcomes) values.push_back(column.value(outcome));
      cells.push_back(mean_label(scoring::summarise(values), {.decimals = column.decimals}));
    }
    table.row(cells);
  }
  if (!any) return {};
  return {{"twins", "How the trainings of the twins ended on " + grid.dataset,
           "Losses are means of the last epoch. The column after each weight of eq. 23 is the "
           "weight divided by its stationary point 1 / (2 L): 1 means that it is reached. Open: "
           "known windows whose contact (eq. 22) does not touch at rest.",
           table}};
}

}  // namespace piae::report
