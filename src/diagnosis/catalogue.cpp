#include "diagnosis/catalogue.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "diagnosis/line_rules.hpp"
#include "diagnosis/nearest.hpp"
#include "diagnosis/spectral_inputs.hpp"
#include "diagnosis/symptom_net.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::diagnosis {

namespace {

using signal::WindowSet;

WdcnnResult ask_nearest(const WindowSet& /*normal*/, const WindowSet& training,
                        const WindowSet& test, const Stream& /*stream*/,
                        const EpochDone& /*epoch_done*/) {
  WdcnnResult result;
  result.predictions = classify_by_nearest(training, test);
  result.outputs.scores = scores_of_named(result.predictions, test.info.classes.size());
  return result;
}

template <Rule rule>
WdcnnResult ask_rule(const WindowSet& normal, const WindowSet& /*training*/, const WindowSet& test,
                     const Stream& /*stream*/, const EpochDone& /*epoch_done*/) {
  RuleAnswer answer = classify_by_rule(normal, test, rule);
  WdcnnResult result;
  result.predictions = std::move(answer.predictions);
  result.outputs.scores = std::move(answer.scores);
  return result;
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
     .ask = ask_nearest},
    {.name = "envelope-rule",
     .what = "fault lines against healthy windows, without any training",
     .input = "the envelope spectrum over orders of the shaft",
     .rule = true,
     .ask = ask_rule<Rule::envelope>},
    {.name = "exclusion-rule",
     .what = "the same; and a change without a line is a ball",
     .input = "the envelope spectrum over orders of the shaft and the log power in 48 bands",
     .rule = true,
     .ask = ask_rule<Rule::exclusion>},
    {.name = "symptom-net",
     .what = "a small network on symptoms",
     .input = "17 symptoms: fault lines, kurtosis, rise of bands, novelty",
     .ask = train_and_test_symptoms,
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
