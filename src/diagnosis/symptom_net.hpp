#pragma once

#include <memory>

#include "base/random.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/symptom_inputs.hpp"
#include "diagnosis/symptom_network.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Training settings of symptom-net. They matter little, because the network is small and its few
/// inputs share one scale: dropout and noise gain half a point on hit-sm, weight decay nothing.
struct SymptomTraining {
  static constexpr std::int64_t epochs = 60;
  static constexpr std::int64_t batch = 64;
  static constexpr double learning_rate =
      2e-3;                             ///< of Adam in epoch 1; falls as half a cosine to 0
  static constexpr double noise = 0.1;  ///< added to the symptoms, in their standard deviations
};

/// The network symptom-net (symptom_network.hpp) with the scale of its symptoms.
class SymptomNet final : public Trained {
 public:
  SymptomNet(SymptomScale scale, std::int64_t classes, const Stream& initial)
      : scale_(std::move(scale)),
        classes_(classes),
        network_(classes, SymptomTraining::batch, initial) {}
  SymptomNet(const artefact::Reader& reader, const signal::DatasetInfo& info);

  /// Trains. Order, noise and dropout of epoch e, counted from 1, come from
  /// stream.child("epoch<e>") and its children "noise" and "dropout".
  Training train(const Stream& stream, const EpochDone& epoch_done);

  Outputs outputs(const signal::WindowSet& windows, const std::string& what) override;
  void write(artefact::Writer& writer) const override;

 private:
  void run_epoch(std::int64_t epoch, const Stream& stream, Training& training);

  SymptomScale scale_;
  std::int64_t classes_;
  SymptomNetwork network_;
};

/// Trains a network on the symptoms (symptom_inputs.hpp) of B and of all fault windows in
/// `training`, and returns the network of the last epoch. Initial values come from
/// stream.child("initial"). Throws as SymptomScale does.
Learned train_symptom_net(const signal::WindowSet& normal, const signal::WindowSet& training,
                          const Stream& stream, const EpochDone& epoch_done = {});
std::unique_ptr<Trained> read_symptom_net(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier symptom_net{
    .name = "symptom-net",
    .what = "a small network on symptoms",
    .input = "17 symptoms: fault lines, kurtosis, rise of bands, novelty",
    .slowest = slowest_of_symptoms,
    .fastest = fastest_of_symptoms,
    .learn = train_symptom_net,
    .read = read_symptom_net,
    .own_epochs = SymptomTraining::epochs};

}  // namespace piae::diagnosis
