#pragma once

#include <memory>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/symptom_inputs.hpp"
#include "diagnosis/symptom_network.hpp"
#include "diagnosis/symptom_training.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// The network symptom-net (symptom_network.hpp) with the scale of its symptoms.
class SymptomNet final : public Trained {
 public:
  SymptomNet(SymptomScale scale, std::int64_t classes, const Stream& initial)
      : scale_(std::move(scale)),
        classes_(classes),
        network_(classes, SymptomTraining::batch, initial) {}
  SymptomNet(const artefact::Reader& reader, const signal::DatasetInfo& info);

  /// Trains (symptom_training.hpp).
  Training train(const Stream& stream, const EpochDone& epoch_done);

  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  SymptomScale scale_;
  std::int64_t classes_;
  SymptomNetwork network_;
};

/// Trains a network on the symptoms (symptom_inputs.hpp) of B and of all fault windows in
/// `training`, and returns the network of the last epoch. Initial values come from
/// stream.child("initial"). Throws as SymptomScale does.
Learned train_symptom_net(const signal::WindowSet& normal, const signal::WindowSet& training,
                          double prewhitening, const Stream& stream,
                          const EpochDone& epoch_done = {});
std::unique_ptr<Trained> read_symptom_net(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier symptom_net{
    .name = "symptom-net",
    .what = "a small network on symptoms",
    .input = "17 symptoms: fault lines, kurtosis, rise of bands, novelty",
    .slowest = slowest_of_symptoms,
    .fastest = fastest_of_symptoms,
    .prewhitening = 0,  // 0.5 would lose blind records: docs/any-bearing.md
    .learn = train_symptom_net,
    .read = read_symptom_net,
    .own_epochs = SymptomTraining::epochs};

}  // namespace piae::diagnosis
