#include "transfer/healthy.hpp"

#include <algorithm>

#include "impacts/ranges.hpp"
#include "impacts/response.hpp"

namespace piae::transfer {

namespace {

const std::string conditions_path = "/healthy/condition";
const std::string spectra_path = "/healthy/log_amplitude";

}  // namespace

std::vector<HealthySpectrum> healthy_spectra(const signal::WindowSet& healthy) {
  std::vector<HealthySpectrum> spectra;
  for (const std::int32_t condition : healthy.info.tested_conditions()) {
    const std::vector<std::size_t> windows = impacts::windows_in(healthy, condition);
    if (windows.empty()) continue;
    const Eigen::ArrayXd seen = impacts::log_amplitude(healthy, windows);
    spectra.push_back({.condition = condition, .log_amplitude = seen - seen.mean()});
  }
  return spectra;
}

const HealthySpectrum* find_spectrum(const std::vector<HealthySpectrum>& spectra,
                                     std::int32_t condition) {
  const auto found = std::ranges::find(spectra, condition, &HealthySpectrum::condition);
  return found == spectra.end() ? nullptr : &*found;
}

void write(artefact::Writer& writer, const std::vector<HealthySpectrum>& spectra) {
  if (spectra.empty()) return;
  std::vector<std::int32_t> conditions;
  std::vector<double> numbers;
  for (const HealthySpectrum& spectrum : spectra) {
    conditions.push_back(spectrum.condition);
    numbers.insert(numbers.end(), spectrum.log_amplitude.begin(), spectrum.log_amplitude.end());
  }
  writer.numbers(conditions_path, conditions);
  writer.numbers(spectra_path, numbers, {spectra.size(), numbers.size() / spectra.size()});
}

std::vector<HealthySpectrum> read_healthy_spectra(const artefact::Reader& reader,
                                                  const signal::WindowSet& known) {
  if (!reader.has("/healthy")) return {};
  const std::vector<std::int32_t> conditions =
      reader.numbers<std::int32_t>(conditions_path, {0}).values;
  const std::size_t bins = known.length + known.length % 2 + 1;
  const std::vector<double> numbers =
      reader.numbers<double>(spectra_path, {conditions.size(), bins}).values;
  reader.require_all(spectra_path, numbers, impacts::ranges::log_amplitude);
  const std::vector<std::int32_t> tested = known.info.tested_conditions();
  std::vector<HealthySpectrum> spectra;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (std::ranges::find(tested, conditions[i]) == tested.end()) {
      reader.refuse(conditions_path, "names a condition that is not tested");
    }
    if (find_spectrum(spectra, conditions[i]) != nullptr) {
      reader.refuse(conditions_path, "names a condition twice");
    }
    spectra.push_back({.condition = conditions[i],
                       .log_amplitude = Eigen::Map<const Eigen::ArrayXd>(
                           numbers.data() + i * bins, static_cast<Eigen::Index>(bins))});
  }
  return spectra;
}

}  // namespace piae::transfer
