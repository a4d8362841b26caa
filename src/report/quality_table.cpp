#include "report/quality_table.hpp"

#include <spdlog/fmt/fmt.h>

#include "report/csv.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

namespace {

using scoring::QualityRecord;

std::string line_of(const std::vector<const QualityRecord*>& seeds, std::size_t i,
                    const scoring::Metric& metric) {
  std::vector<double> values;
  values.reserve(seeds.size());
  for (const QualityRecord* record : seeds) values.push_back(record->classes[i].*metric.value);
  const scoring::Summary summary = scoring::summarise(values);
  const QualityRecord& first = *seeds.front();
  const auto label = static_cast<std::size_t>(first.classes[i].label);
  return csv_line({first.info.name, first.method, first.info.classes[label].name, metric.name,
                   std::to_string(summary.count), fmt::format("{:.6g}", summary.mean),
                   summary.deviation ? fmt::format("{:.6g}", *summary.deviation) : ""});
}

}  // namespace

std::string quality_csv(const Grid& grid, const Results& results) {
  std::string text = csv_line({"dataset", "method", "class", "metric", "seeds", "mean", "std"});
  for (const std::string& method : grid.generators) {
    std::vector<const QualityRecord*> seeds;
    for (const QualityRecord& record : results.qualities) {
      if (record.method == method) seeds.push_back(&record);
    }
    for (std::size_t i = 0; i < seeds.front()->classes.size(); ++i) {
      for (const scoring::Metric& metric : scoring::all_metrics()) {
        text += line_of(seeds, i, metric);
      }
    }
  }
  return text;
}

}  // namespace piae::report
