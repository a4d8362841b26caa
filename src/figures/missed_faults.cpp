#include "figures/missed_faults.hpp"

#include <algorithm>

#include "figures/most_windows.hpp"

namespace piae::figures {

namespace {

/// Windows of some classes, and those predicted on the wrong side of healthy and faulty.
struct Alarms {
  std::int64_t wrong = 0;
  std::int64_t windows = 0;

  [[nodiscard]] double percent() const {
    return 100.0 * static_cast<double>(wrong) / static_cast<double>(windows);
  }
};

/// Counts faults of these classes predicted as healthy, or healthy windows predicted as a fault.
Alarms wrong_alarms(const scoring::DiagnosisRecord& record, const std::vector<Label>& labels) {
  const Label healthy = record.info.healthy_label();
  Alarms alarms;
  for (std::size_t i = 0; i < record.labels.size(); ++i) {
    if (std::ranges::find(labels, record.labels[i]) == labels.end()) continue;
    ++alarms.windows;
    alarms.wrong += (record.predictions[i] == healthy) != (record.labels[i] == healthy);
  }
  return alarms;
}

void add_alarms(Numbers& numbers, const MethodDiagnoses& method, const std::string& kind,
                const std::string& class_name, const std::vector<Label>& labels) {
  double sum = 0;
  const auto add = [&](const std::string& seed, double percent) {
    std::vector<std::string> row = method.fields();
    row.insert(row.end(), {kind, class_name, seed, digits(percent)});
    numbers.row(row);
  };
  for (const scoring::DiagnosisRecord& record : method.seeds) {
    const Alarms alarms = wrong_alarms(record, labels);
    if (alarms.windows == 0) return;
    add(std::to_string(record.seed), alarms.percent());
    sum += alarms.percent();
  }
  add("mean", sum / static_cast<double>(method.seeds.size()));
}

}  // namespace

Numbers missed_faults(Source& source) {
  Numbers numbers({"method", "ceiling", "ratio", "kind", "class", "seed", "percent"});
  for (const MethodDiagnoses& method : diagnoses_with_most_windows(source)) {
    const signal::DatasetInfo& info = method.info();
    add_alarms(numbers, method, "all-faults", "", info.fault_labels());
    for (const Label label : info.fault_labels()) {
      add_alarms(numbers, method, "fault", info.class_of(label).name, {label});
    }
    add_alarms(numbers, method, "healthy", "", {info.healthy_label()});
  }
  return numbers;
}

}  // namespace piae::figures
