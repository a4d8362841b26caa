#include "scoring/quality_record.hpp"

#include "signal/ranges.hpp"
#include "signal/roles.hpp"

namespace piae::scoring {

double QualityRecord::mean_over_classes(const Metric& metric) const {
  double sum = 0;
  std::size_t count = 0;
  for (const ClassQuality& quality : classes) {
    if (metric.is_of_line && !has_line(info, quality.label)) continue;
    sum += quality.*metric.value;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

void write(artefact::Writer& writer, const QualityRecord& record) {
  signal::write(writer, record.info);
  writer.attribute("/", "method", record.method);
  writer.attribute("/", "seed", record.seed);
  writer.attribute("/", "protocol", to_string(record.protocol));
  std::vector<Label> labels;
  std::vector<std::int64_t> windows;
  for (const ClassQuality& quality : record.classes) {
    labels.push_back(quality.label);
    windows.push_back(quality.windows);
  }
  writer.numbers("/labels", labels);
  writer.numbers("/windows_compared", windows);
  for (const Metric& metric : all_metrics()) {
    std::vector<double> values;
    for (const ClassQuality& quality : record.classes) values.push_back(quality.*metric.value);
    writer.numbers(std::string("/quality/") + metric.name, values);
  }
}

QualityRecord read_quality(const artefact::Reader& reader) {
  QualityRecord record;
  record.info = signal::read_dataset_info(reader);
  record.method = signal::read_method(reader);
  record.seed = reader.integer("/", "seed", signal::ranges::seed);
  record.protocol = signal::read_protocol(reader);
  const auto labels = reader.numbers<Label>("/labels", {0}).values;
  const auto windows = reader.numbers<std::int64_t>("/windows_compared", {labels.size()}).values;
  reader.require_all("/windows_compared", windows, {.low = 1, .high = 1e12});
  const std::size_t classes = record.info.classes.size();
  if (labels.empty()) reader.refuse("/labels", "is empty");
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0 || index_of(labels[i]) >= classes || (i > 0 && labels[i] <= labels[i - 1])) {
      reader.refuse("/labels", "are not labels of the data set's classes in increasing order");
    }
    record.classes.push_back({.label = labels[i], .windows = windows[i]});
  }
  for (const Metric& metric : all_metrics()) {
    const auto values =
        reader.numbers<double>(std::string("/quality/") + metric.name, {labels.size()}).values;
    for (std::size_t i = 0; i < values.size(); ++i) record.classes[i].*metric.value = values[i];
  }
  return record;
}

}  // namespace piae::scoring
