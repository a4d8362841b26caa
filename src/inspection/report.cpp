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
  const auto counted = [](std::size_t n, const char* one, const char* several) {
    return fmt::format("{} {}", n, n == 1 ? one : several);
  };
  return text + fmt::format("checked {} of {}, warnings: {}\n",
                            counted(check.records.size(), "record", "records"),
                            counted(check.classes.size(), "class", "classes"), warnings.size());
}

}  // namespace piae::inspection
