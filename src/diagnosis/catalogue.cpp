#include "diagnosis/catalogue.hpp"

#include <algorithm>

#include "base/comma_list.hpp"
#include "base/error.hpp"
#include "diagnosis/adapting.hpp"
#include "diagnosis/any_bearing.hpp"
#include "diagnosis/line_rules.hpp"
#include "diagnosis/nearest_orders.hpp"
#include "diagnosis/prototypes.hpp"
#include "diagnosis/symptom_net.hpp"
#include "diagnosis/wdcnn_inputs.hpp"

namespace piae::diagnosis {

namespace {

constexpr Classifier known_classifiers[] = {
    wdcnn,         wdcnn_spectrum, wdcnn_envelope, wdcnn_spectra, nearest,
    envelope_rule, exclusion_rule, symptom_net,    wdcnn_orders,  nearest_orders,
    prototypes,    any_bearing,    dann,           cdan,
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
  throw Error(Exit::usage, "unknown classifier '" + name +
                               "'; known: " + comma_list(known_classifiers, &Classifier::name));
}

std::string marked_name(const std::string& classifier) {
  const Classifier* const found = find_classifier(classifier);
  return found != nullptr && found->adapts() ? classifier + " (sees D)" : classifier;
}

std::vector<std::string> rules() {
  std::vector<std::string> names;
  for (const Classifier& each : known_classifiers) {
    if (each.rule) names.emplace_back(each.name);
  }
  return names;
}

std::string list_of_classifiers() {
  return comma_list(known_classifiers, [](const Classifier& each) {
    return std::string(each.name) + " (" + each.what + ")";
  });
}

}  // namespace piae::diagnosis
