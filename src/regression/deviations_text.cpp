#include "regression/deviations_text.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "run/grid.hpp"
#include "text/table.hpp"

namespace piae::regression {

namespace {

std::string joined(const std::set<std::string>& texts) {
  std::string line;
  for (const std::string& text : texts) line += (line.empty() ? "" : " | ") + text;
  return line;
}

std::string heading(const Measurements& reference, const Measurements& run, Tolerance tolerance) {
  std::string text = fmt::format("{}, protocol {}\n", run.dataset, to_string(run.protocol));
  text +=
      fmt::format("  reference  {}; {}\n", joined(reference.versions), joined(reference.settings));
  text += fmt::format("  run        {}; {}\n", joined(run.versions), joined(run.settings));
  text += tolerance == Tolerance::exact
              ? "  tolerance  exact: every seed must give the same number\n"
              : "  tolerance  spread: means may differ by the allowed standard errors\n";
  return text;
}

std::string table_of(const std::vector<DeviationRow>& rows) {
  text::Table table({"method", "ratio", "quantity", "", "seeds", "moved", "reference", "run",
                     "difference", "std errors", "allowed"},
                    4);
  for (const DeviationRow& row : rows) {
    const auto errors = row.standard_errors();
    const bool is_score = row.ratio.empty();
    table.row({is_score ? row.method : run::name_by(row.method, row.classifier),
               is_score ? "score" : row.ratio, row.quantity, row.within ? "" : "OUTSIDE",
               std::to_string(row.seeds), std::to_string(row.moved_seeds),
               fmt::format("{:.6g}", row.reference), fmt::format("{:.6g}", row.run),
               fmt::format("{:+.3g}", row.difference()),
               errors ? fmt::format("{:+.2f}", *errors) : "unknown",
               errors ? fmt::format("{:.2f}", row.allowed) : ""});
  }
  return table.plain();
}

std::string list_of(const std::string& title, const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text += title + cell + '\n';
  return text;
}

}  // namespace

std::string deviations_text(const Measurements& reference, const Measurements& run,
                            Tolerance tolerance, const Deviations& deviations) {
  std::vector<DeviationRow> moved;
  std::ranges::copy_if(deviations.rows, std::back_inserter(moved),
                       [](const DeviationRow& row) { return row.moved_seeds > 0; });
  std::string text = heading(reference, run, tolerance);
  if (!moved.empty()) text += table_of(moved);
  text += list_of("missing in the run: ", deviations.missing);
  text += list_of("not in the reference: ", deviations.not_in_reference);
  return text + fmt::format("compared {} quantities of {}: {} moved, {} outside the tolerance\n",
                            deviations.rows.size(), run.dataset, moved.size(),
                            std::ranges::count(moved, false, &DeviationRow::within));
}

}  // namespace piae::regression
