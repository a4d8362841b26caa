#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/label.hpp"
#include "diagnosis/classifier.hpp"
#include "diagnosis/symptom_network.hpp"
#include "diagnosis/symptom_standard.hpp"
#include "diagnosis/symptom_training.hpp"
#include "symptoms/symptoms.hpp"

namespace piae::diagnosis {

/// The stored network, below the folder of the project. `teach` makes it.
inline constexpr const char* any_bearing_file = "results/reference/any-bearing.h5";

/// A network on symptoms that was taught on simulated machines alone (machines/lessons.hpp).
/// Symptoms mean the same on every machine, so it predicts the fault type on any machine with a
/// known bearing and healthy windows.
class AnyBearingNetwork {
 public:
  /// Outputs: healthy, then symptoms::fault_types.
  static constexpr std::int64_t outputs = 1 + symptoms::number_of_fault_types;
  /// More than symptom-net's: simulated machines differ from real ones, so that details of a
  /// symptom mislead. Tried 0.1, 0.3 and 0.5 (pipeline/protocol.toml).
  static constexpr SymptomTraining settings{.noise = 0.5};

  /// Teaches a network. `labels` are indices of outputs; `prewhitening` is that of the symptoms.
  AnyBearingNetwork(const std::vector<symptoms::Symptoms>& lessons,
                    const std::vector<Label>& labels, double prewhitening, const Stream& stream,
                    const EpochDone& epoch_done = {});

  /// Writes the standard and the parameters of the network below /learned, with the attribute
  /// prewhitening.
  void write(artefact::Writer& writer) const;

  [[nodiscard]] const Training& training() const { return training_; }

 private:
  double prewhitening_ = 0;
  SymptomRows rows_;  ///< of the lessons, empty after teaching
  SymptomStandard standard_;
  SymptomNetwork network_;
  Training training_;
};

/// Throws artefact::Refusal unless the file holds such a network.
void require_any_bearing(const artefact::Reader& reader);

/// Fits the network of a file to a machine: its healthy windows become the reference. Throws
/// Error(bad_input) as TrainedRule does, and artefact::Refusal for another file.
std::unique_ptr<Trained> fit_any_bearing(const artefact::Reader& network,
                                         const signal::WindowSet& normal);
std::unique_ptr<Trained> read_any_bearing(const artefact::Reader& reader,
                                          const signal::DatasetInfo& info, std::size_t length);

inline constexpr Classifier any_bearing{
    .name = "any-bearing",
    .what = "a small network on symptoms, taught on simulated machines only",
    .input = "17 symptoms: fault lines, kurtosis, rise of bands, novelty",
    .rule = true,
    .slowest = slowest_of_symptoms,
    .fastest = fastest_of_symptoms,
    .read = read_any_bearing,
    .fit = fit_any_bearing};

}  // namespace piae::diagnosis
