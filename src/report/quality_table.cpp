#include "report/quality_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "report/labels.hpp"
#include "report/paper.hpp"
#include "scoring/statistics.hpp"
#include "text/csv.hpp"

namespace piae::report {

namespace {

using scoring::Metric;
using scoring::QualityRecord;
using scoring::Summary;

/// Scores of one method, by seed.
using Seeds = std::vector<const QualityRecord*>;

Seeds seeds_of(const std::string& method, const run::Results& results) {
  Seeds seeds;
  for (const QualityRecord& record : results.qualities) {
    if (record.method == method) seeds.push_back(&record);
  }
  return seeds;
}

const std::string& class_name(const QualityRecord& record, std::size_t i) {
  return record.info.class_of(record.classes[i].label).name;
}

Summary of_class(const Seeds& seeds, std::size_t i, const Metric& metric) {
  std::vector<double> values;
  for (const QualityRecord* record : seeds) values.push_back(record->classes[i].*metric.value);
  return scoring::summarise(values);
}

Summary of_all_classes(const Seeds& seeds, const Metric& metric) {
  std::vector<double> means;
  for (const QualityRecord* record : seeds) means.push_back(record->mean_over_classes(metric));
  return scoring::summarise(means);
}

std::string line_of(const Seeds& seeds, std::size_t i, const Metric& metric) {
  const Summary summary = of_class(seeds, i, metric);
  const QualityRecord& first = *seeds.front();
  return text::csv_line({first.info.name, first.method, class_name(first, i), metric.name,
                         std::to_string(summary.count), fmt::format("{:.6g}", summary.mean),
                         summary.deviation ? fmt::format("{:.6g}", *summary.deviation) : ""});
}

/// Returns the number of decimals that gives the smallest of these numbers three significant
/// digits, but at most `most`.
int decimals_for(const std::vector<std::vector<Summary>>& rows, int most) {
  int decimals = 1;
  for (const auto& row : rows) {
    for (const Summary& summary : row) {
      const double size = std::abs(summary.mean);
      if (size > 0)
        decimals = std::max(decimals, 2 - static_cast<int>(std::floor(std::log10(size))));
    }
  }
  return std::min(decimals, most);
}

text::Table metric_table(const std::vector<Seeds>& methods, const Metric& metric) {
  std::vector<std::string> header{"class"};
  for (const Seeds& seeds : methods) header.push_back(seeds.front()->method);
  const QualityRecord& first = *methods.front().front();
  const std::size_t classes = first.classes.size();
  std::vector<std::vector<Summary>> rows(classes + 1);
  for (const Seeds& seeds : methods) {
    for (std::size_t i = 0; i < classes; ++i) rows[i].push_back(of_class(seeds, i, metric));
    rows[classes].push_back(of_all_classes(seeds, metric));
  }
  const NumberStyle style{decimals_for(rows, metric.decimals)};
  text::Table table(header, 1);
  for (std::size_t i = 0; i <= classes; ++i) {
    std::vector<std::string> cells{i < classes ? class_name(first, i) : "mean of classes"};
    for (const Summary& summary : rows[i]) cells.push_back(mean_label(summary, style));
    table.row(cells);
  }
  return table;
}

}  // namespace

std::string quality_csv(const run::Grid& grid, const run::Results& results) {
  std::string text =
      text::csv_line({"dataset", "method", "class", "metric", "seeds", "mean", "std"});
  for (const std::string& method : grid.scored) {
    const Seeds seeds = seeds_of(method, results);
    for (std::size_t i = 0; i < seeds.front()->classes.size(); ++i) {
      for (const Metric& metric : scoring::all_metrics()) text += line_of(seeds, i, metric);
    }
  }
  return text;
}

std::vector<Section> quality_sections(const run::Grid& grid, const run::Results& results) {
  const PaperReference reference(grid.dataset);
  std::vector<Section> sections;
  for (const MethodGroup& group : method_groups(grid.scored)) {
    std::vector<Seeds> methods;
    for (const std::string& method : group.methods) methods.push_back(seeds_of(method, results));
    for (const Metric& metric : scoring::all_metrics()) {
      const Place place =
          metric.in_paper ? reference.figure(group.quality_figure) : reference.none();
      const bool drawn = metric.in_paper && reference.counterpart();
      sections.push_back(place.of(
          {"quality-" + group.key + "-" + metric.name,
           "Quality of " + group.name + " on " + grid.dataset + ": " + metric.title,
           metric.meaning +
               std::string(drawn ? " The paper shows it in a figure without numbers." : ""),
           metric_table(methods, metric)}));
    }
  }
  return sections;
}

}  // namespace piae::report
