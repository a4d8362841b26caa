#pragma once

#include <vector>

#include "diagnosis/any_bearing.hpp"
#include "diagnosis/stored.hpp"

namespace piae::diagnosis {

/// Teaches a network on made-up symptoms: the lines of the fault type are high, and faulty windows
/// are new. Stores it and opens it for reading.
inline artefact::Reader taught_network(const Folder& folder, double prewhitening = 0) {
  std::vector<symptoms::Symptoms> lessons;
  std::vector<Label> labels;
  Stream stream("lessons");
  for (int i = 0; i < 400; ++i) {
    const auto label = static_cast<Label>(i % 4);
    symptoms::Symptoms one{};
    for (double& symptom : one) symptom = stream.normal(0, 0.1);
    for (int n = 0; n < 4 && label > 0; ++n) one.at(4 * (index_of(label) - 1) + n) += 1;
    one[12] += label > 0 ? 2 : 1;       // kurtosis
    one[16] += label > 0 ? 1.5 : -0.5;  // novelty
    lessons.push_back(one);
    labels.push_back(label);
  }
  artefact::Writer writer("any-bearing");
  AnyBearingNetwork(lessons, labels, prewhitening, Stream("taught")).write(writer);
  return stored(writer, folder, "any-bearing.h5");
}

}  // namespace piae::diagnosis
