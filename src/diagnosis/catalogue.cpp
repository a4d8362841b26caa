#include "diagnosis/catalogue.hpp"

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "diagnosis/line_rules.hpp"
#include "diagnosis/nearest.hpp"
#include "diagnosis/spectral_inputs.hpp"
#include "diagnosis/symptom_net.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

namespace {

using signal::DatasetInfo;
using signal::WindowSet;

Learned learn_nearest(const WindowSet& /*normal*/, const WindowSet& training,
                      const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<Nearest>(training), .training = {}};
}

std::unique_ptr<Trained> read_nearest(const artefact::Reader& reader, const DatasetInfo& info,
                                      std::size_t length) {
  return std::make_unique<Nearest>(reader, info, length);
}

template <Rule rule>
Learned learn_rule(const WindowSet& normal, const WindowSet& /*training*/, const Stream& /*stream*/,
                   const EpochDone& /*epoch_done*/) {
  return {.trained = std::make_unique<TrainedRule>(normal, rule), .training = {}};
}

template <Rule rule>
std::unique_ptr<Trained> read_rule(const artefact::Reader& reader, const DatasetInfo& info,
                                   std::size_t /*length*/) {
  return std::make_unique<TrainedRule>(reader, info, rule);
}

std::unique_ptr<Trained> read_symptom_net(const artefact::Reader& reader, const DatasetInfo& info,
                                          std::size_t /*length*/) {
  return std::make_unique<SymptomNet>(reader, info);
}

constexpr Classifier known_classifiers[] = {
    {.name = scoring::paper_classifier,
     .what = "the paper's network",
     .input = "the waveform",
     .represent = standardise},
    {.name = "wdcnn-spectrum",
     .what = "the same network on spectra",
     .input = "the log amplitude spectrum",
     .represent = log_spectra},
    {.name = "wdcnn-envelope",
     .what = "the same network on envelope spectra",
     .input = "the log envelope spectrum",
     .represent = log_envelope_spectra},
    {.name = "wdcnn-spectra",
     .what = "the same network on both spectra side by side",
     .input = "the log amplitude spectrum and the log envelope spectrum",
     .represent = both_log_spectra},
    {.name = bar_classifier,
     .what = "the nearest known or generated window, without any training",
     .input = "the log power in 128 bands",
     .learn = learn_nearest,
     .read = read_nearest},
    {.name = "envelope-rule",
     .what = "fault lines against healthy windows, without any training",
     .input = "the envelope spectrum over orders of the shaft",
     .rule = true,
     .learn = learn_rule<Rule::envelope>,
     .read = read_rule<Rule::envelope>},
    {.name = "exclusion-rule",
     .what = "the same; and a change without a line is a ball",
     .input = "the envelope spectrum over orders of the shaft and the log power in 48 bands",
     .rule = true,
     .learn = learn_rule<Rule::exclusion>,
     .read = read_rule<Rule::exclusion>},
    {.name = "symptom-net",
     .what = "a small network on symptoms",
     .input = "17 symptoms: fault lines, kurtosis, rise of bands, novelty",
     .learn = train_symptom_net,
     .read = read_symptom_net,
     .own_epochs = SymptomTraining::epochs},
};

}  // namespace

std::span<const Classifier> classifiers() { return known_classifiers; }

const Classifier* find_classifier(const std::string& name) {
  const auto* const found = std::ranges::find(known_classifiers, name, &Classifier::name);
  return found == std::end(known_classifiers) ? nullptr : found;
}

const Classifier& the_classifier(const std::string& name) {
  const Classifier* const found = find_classifier(name);
  if (found != nullptr) return *found;
  std::string known;
  for (const Classifier& each : known_classifiers) {
    known += std::string(known.empty() ? "" : ", ") + each.name;
  }
  throw Error(Exit::usage, "unknown classifier '" + name + "'; known are " + known);
}

std::vector<std::string> rules() {
  std::vector<std::string> names;
  for (const Classifier& each : known_classifiers) {
    if (each.rule) names.emplace_back(each.name);
  }
  return names;
}

std::string list_of_classifiers() {
  std::string list;
  for (const Classifier& each : known_classifiers) {
    list += std::string(list.empty() ? "" : ", ") + each.name + " (" + each.what + ")";
  }
  return list;
}

}  // namespace piae::diagnosis
