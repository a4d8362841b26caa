#include "classification/fitted.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "diagnosis/any_bearing.hpp"
#include "machines/machine.hpp"
#include "scoring/ratios.hpp"
#include "signal/description.hpp"

namespace piae::classification {

namespace {

constexpr std::size_t windows_overlap = 4;

signal::DatasetInfo described_machine(const Sources& sources) {
  if (!sources.records_file.empty()) {
    return signal::read_dataset_info(artefact::Reader(sources.records_file, "records"));
  }
  return signal::read_description(sources.description).info;
}

signal::DatasetInfo machine_of(signal::DatasetInfo info) {
  info.classes = machines::fault_type_classes();
  info.conditions.clear();
  return info;
}

std::size_t length_at(double rate_hz, double speed_rpm) {
  const double needed = machines::least_turns * 60 * rate_hz / speed_rpm;
  std::size_t length = machines::window_length;
  while (static_cast<double>(length) < needed) length *= 2;
  return length;
}

/// Throws if a record that is to be the healthy reference is of a class with a defect.
void require_healthy(const std::vector<Recording>& records, const signal::DatasetInfo& described) {
  for (const Recording& record : records) {
    const auto said =
        std::ranges::find(described.classes, record.true_class, &signal::ClassInfo::name);
    if (said == described.classes.end() || said->defect == signal::Defect::none) continue;
    throw Error(
        Exit::usage,
        fmt::format("--healthy: record {} is of class {}, which has a defect; name records "
                    "of class {}",
                    record.name, said->name, described.class_of(described.healthy_label()).name));
  }
}

/// Returns the windows of the healthy records.
signal::WindowSet reference_of(const std::vector<Recording>& healthy,
                               const signal::DatasetInfo& info, std::size_t length) {
  signal::WindowSet all;
  all.info = info;
  all.length = length;
  for (const Recording& recording : healthy) {
    const signal::WindowSet own = windows_of(recording, info, length, length / windows_overlap);
    for (std::size_t i = 0; i < own.size(); ++i) all.append(own, i);
  }
  return all;
}

}  // namespace

diagnosis::KeptClassifier fit_to_machine(cli::Stage& stage, const artefact::Reader& network,
                                         const Sources& sources) {
  if (!sources.lone.file.empty() || sources.healthy.empty()) {
    throw Error(Exit::usage,
                "--classifier is a network for all machines, which needs healthy records of this "
                "one: give --description or --records, and name them by --healthy");
  }
  const signal::DatasetInfo described = described_machine(sources);
  signal::DatasetInfo info = machine_of(described);
  Sources of_healthy = sources;
  of_healthy.records = sources.healthy;
  const std::vector<Recording> healthy = read(stage, of_healthy, diagnosis::any_bearing, info);
  require_healthy(healthy, described);
  info.shaft_speed_rpm = healthy.front().shaft_speed_rpm;
  const std::size_t length = length_at(info.sample_rate_hz, info.shaft_speed_rpm);
  const signal::WindowSet reference = reference_of(healthy, info, length);
  return {info,
          length,
          diagnosis::any_bearing,
          diagnosis::fit_any_bearing(network, reference),
          {},
          std::nullopt,
          {.method = "none",
           .ratio = scoring::all_ratios().front().name,
           .training_windows = std::ssize(reference.labels),
           .training_digest = {}}};
}

}  // namespace piae::classification
