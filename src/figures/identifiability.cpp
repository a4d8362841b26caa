#include "figures/identifiability.hpp"

#include "figures/stored_table.hpp"
#include "signal/window_set.hpp"

namespace piae::figures {

namespace {

void require_simulated(const Source& source) {
  const auto file = source.layout().known_windows(source.shown_seed());
  if (!signal::read_window_set({file, "windows"}).parameters.empty()) return;
  throw LeftOut("the true stiffness and damping are known only for simulated windows");
}

void require_table(const std::filesystem::path& file) {
  if (std::filesystem::exists(file)) return;
  throw LeftOut("not yet compared with the true values, run `make identify`: no " +
                file.filename().string());
}

std::string r2_of(const StoredTable& agreement, const std::string& method,
                  const std::string& parameter) {
  for (std::size_t i = 0; i < agreement.rows(); ++i) {
    if (agreement.at(i, "method") == method && agreement.at(i, "parameter") == parameter &&
        agreement.at(i, "class") == "all") {
      return agreement.at(i, "r2_mean");
    }
  }
  return "";
}

}  // namespace

Numbers identifiability(Source& source) {
  require_simulated(source);
  require_table(source.layout().scatter_csv());
  require_table(source.layout().identifiability_csv());
  const StoredTable scatter(source.layout().scatter_csv());
  const StoredTable agreement(source.layout().identifiability_csv());
  const std::vector<std::string> columns{"method",  "parameter",    "truth_low",    "truth_high",
                                         "windows", "inferred_p10", "inferred_p50", "inferred_p90"};
  std::vector<std::string> header = columns;
  header.emplace_back("r2");
  Numbers numbers(header);
  for (std::size_t i = 0; i < scatter.rows(); ++i) {
    std::vector<std::string> fields;
    for (const std::string& column : columns) fields.push_back(scatter.at(i, column));
    fields.push_back(r2_of(agreement, scatter.at(i, "method"), scatter.at(i, "parameter")));
    numbers.row(fields);
  }
  return numbers;
}

}  // namespace piae::figures
