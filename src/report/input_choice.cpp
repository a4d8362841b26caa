#include "report/input_choice.hpp"

#include "augment/catalogue.hpp"
#include "base/error.hpp"
#include "diagnosis/catalogue.hpp"

namespace piae::report {

namespace {

std::string trained_classifiers() {
  std::string names;
  for (const diagnosis::Classifier& each : diagnosis::classifiers()) {
    if (each.trains()) names += (names.empty() ? "" : ", ") + std::string(each.name);
  }
  return names;
}

}  // namespace

InputChoice parse_input_choice(const std::string& word) {
  const std::size_t equals = word.find('=');
  const auto refuse = [&](const std::string& why) {
    throw Error(Exit::usage, "'" + word + "' " + why);
  };
  if (equals == std::string::npos) {
    refuse("is not METHOD=CLASSIFIER, such as none=wdcnn-spectrum");
  }
  InputChoice choice{word.substr(0, equals), word.substr(equals + 1)};
  if (augment::find_entry(choice.method) == nullptr) refuse("names a method that there is not");
  const diagnosis::Classifier* const classifier = diagnosis::find_classifier(choice.classifier);
  if (classifier == nullptr || !classifier->trains()) {
    refuse("names no classifier that is trained; such are " + trained_classifiers());
  }
  return choice;
}

}  // namespace piae::report
