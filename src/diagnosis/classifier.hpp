#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/adaptation.hpp"
#include "diagnosis/standardise.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// Output of a classifier for n windows.
struct Outputs {
  std::vector<float> hidden;  ///< row-major [n, units]: its last hidden layer, if it has one
  std::vector<float> logits;  ///< row-major [n, classes]: the greatest determines the class
  std::vector<float> scores;  ///< row-major [n, classes]: for a network the softmax of the logits
};

/// Returns [n] the class with the highest score; `scores` are row-major [n, classes].
std::vector<Label> most_likely(std::span<const float> scores, std::size_t classes);

/// A trained classifier of any type, which predicts windows of its data set.
class Trained {
 public:
  virtual ~Trained() = default;

  /// Returns the output for each window. `what` names the set in errors, such as "--test". Throws
  /// Error(bad_input) for windows that the classifier cannot use.
  virtual Outputs outputs(const signal::WindowSet& windows, const std::string& what) = 0;

  /// Writes all that outputs() needs, below /learned.
  virtual void write(artefact::Writer& writer) const = 0;
};

/// Group that write() writes to.
inline constexpr const char* learned = "/learned";

/// Course of a training; empty for classifiers without training.
struct Training {
  std::vector<double> loss;            ///< [epochs] mean cross-entropy over the epoch's windows
  std::vector<double> train_accuracy;  ///< [epochs] in [0, 1]; each window before its own update
  double seconds = 0;                  ///< time of the epochs, without start-up and test
};

struct Learned {
  std::unique_ptr<Trained> trained;
  Training training;
};

/// Called after every epoch with the number of finished epochs and the loss of the last one.
using EpochDone = std::function<void(std::int64_t done, double loss)>;

/// Converts windows to the input of a WDCNN; `what` names the set in errors.
using Represent = LabelledWindows (*)(const signal::WindowSet& windows, const std::string& what);

/// The same for classifiers by symptoms: lines lie at orders of the shaft, and baselines allow for
/// other speeds (symptoms/speed_change.hpp). Tried from 0.5 to 2.
inline constexpr double slowest_of_symptoms = 0.4;
inline constexpr double fastest_of_symptoms = 2.5;

/// A classifier of the catalogue, defined in its own file (nearest.hpp).
struct Classifier {
  const char* name;   ///< the name in CLASSIFIERS, in folders and in tables
  const char* what;   ///< short description
  const char* input;  ///< input made from a window
  /// Makes the input of a WDCNN; null for other classifiers, which have `learn` or `fit`, and
  /// `read`.
  Represent represent = nullptr;
  /// Adaptation of a WDCNN to unlabelled windows, which others do not see: tables mark it.
  Adaptation adaptation = Adaptation::none;
  /// True if it learns from healthy windows alone. It does not need fault windows, known or
  /// generated, and runs with `none` only.
  bool rule = false;
  /// Speeds of recordings that it can judge, over those that it was trained for. The loads of
  /// CWRU's records alone make 4 %.
  double slowest = 0.95;
  double fastest = 1.05;
  /// Prewhitening of its symptoms (symptoms::measure()) unless an option gives another; empty for
  /// classifiers that learn without symptoms.
  std::optional<double> prewhitening = {};
  /// Trains a classifier other than WDCNN. `normal` is B; `training` is the whole training set, B
  /// first. `prewhitening` is 0 for those that learn without symptoms.
  Learned (*learn)(const signal::WindowSet& normal, const signal::WindowSet& training,
                   double prewhitening, const Stream& stream,
                   const EpochDone& epoch_done) = nullptr;
  /// Reads a trained classifier, written for windows of that data set with `length` samples each.
  std::unique_ptr<Trained> (*read)(const artefact::Reader& reader, const signal::DatasetInfo& info,
                                   std::size_t length) = nullptr;
  /// Fits a network that was taught before, for all machines, to one machine; null for classifiers
  /// that learn. Throws as any_bearing.hpp says.
  std::unique_ptr<Trained> (*fit)(const artefact::Reader& network,
                                  const signal::WindowSet& normal) = nullptr;
  std::int64_t own_epochs = 0;  ///< training epochs; 0 for WDCNN and untrained classifiers

  [[nodiscard]] bool adapts() const { return adaptation != Adaptation::none; }
  [[nodiscard]] bool trains() const { return represent != nullptr || own_epochs > 0; }
};

}  // namespace piae::diagnosis
