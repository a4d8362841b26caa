#include "inspection/report.hpp"

#include <spdlog/fmt/fmt.h>

#include "inspection/tables.hpp"
#include "inspection/warnings.hpp"

namespace piae::inspection {

std::string report_of(const signal::Description& description, const DatasetCheck& check) {
  std::string text = tables_of(description, check) + '\n';
  const std::vector<std::string> warnings = warnings_of(description, check);
  for (const std::string& warning : warnings) text += "warning: " + warning + '\n';
  for (const std::string& problem : problems_of(check)) text += problem + '\n';
  if (check.exit != Exit::done) return text;
  return text + fmt::format("checked {} records of {} classes, warnings: {}\n",
                            check.records.size(), check.classes.size(), warnings.size());
}

}  // namespace piae::inspection
