#include "figures/quality.hpp"

#include <algorithm>

#include "figures/groups.hpp"
#include "scoring/quality.hpp"

namespace piae::figures {

namespace {

using scoring::ClassQuality;
using scoring::Metric;
using scoring::QualityRecord;

const ClassQuality& of_label(const QualityRecord& record, Label label) {
  return *std::ranges::find(record.classes, label, &ClassQuality::label);
}

void add_class(Numbers& numbers, const Metric& metric, Label label,
               const std::vector<QualityRecord>& of_method) {
  const QualityRecord& first = of_method.front();
  const std::string class_name = first.info.class_of(label).name;
  double sum = 0;
  for (const QualityRecord& record : of_method) {
    const double value = of_label(record, label).*metric.value;
    sum += value;
    numbers.row(
        {metric.name, class_name, first.method, std::to_string(record.seed), digits(value)});
  }
  numbers.row({metric.name, class_name, first.method, "mean",
               digits(sum / static_cast<double>(of_method.size()))});
}

std::vector<QualityRecord> records_of(const std::vector<QualityRecord>& all,
                                      const std::string& method) {
  std::vector<QualityRecord> records;
  std::ranges::copy_if(all, std::back_inserter(records),
                       [&](const QualityRecord& each) { return each.method == method; });
  return records;
}

Numbers quality_of(Source& source, const std::vector<std::string>& methods) {
  const auto is_shown = [&](const QualityRecord& each) {
    return std::ranges::find(methods, each.method) != methods.end();
  };
  if (std::ranges::none_of(source.qualities(), is_shown)) {
    throw LeftOut("the run has no generated windows");
  }
  Numbers numbers({"metric", "class", "method", "seed", "value"});
  for (const Metric& metric : scoring::all_metrics()) {
    for (const std::string& method : methods) {
      const std::vector<QualityRecord> records = records_of(source.qualities(), method);
      if (records.empty()) continue;  // `none` and ceilings have no score
      for (const ClassQuality& quality : records.front().classes) {
        add_class(numbers, metric, quality.label, records);
      }
    }
  }
  return numbers;
}

}  // namespace

Numbers quality_of_methods(Source& source) {
  return quality_of(source, methods_in(source.grid(), Group::methods));
}

Numbers quality_of_models(Source& source) {
  return quality_of(source, methods_in(source.grid(), Group::models));
}

}  // namespace piae::figures
