#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "base/random.hpp"
#include "diagnosis/standardise.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// The answer of a classifier to n windows.
struct Outputs {
  std::vector<float> hidden;  ///< row-major [n, units]: its last hidden layer, where it has one
  std::vector<float> logits;  ///< row-major [n, classes]: the greatest names the class
  std::vector<float> scores;  ///< row-major [n, classes]: of a network the softmax of the logits
};

/// [n] the class with the highest score, of scores row-major [n, classes].
std::vector<Label> most_likely(std::span<const float> scores, std::size_t classes);

/// A classifier that has learned, whatever it is, and can be asked about windows of its data set.
class Trained {
 public:
  virtual ~Trained() = default;

  /// The answer to each window. `what` names the set in errors, such as "--test". Throws
  /// Error(bad_input) for windows that it cannot be asked about.
  virtual Outputs outputs(const signal::WindowSet& windows, const std::string& what) = 0;

  /// All that outputs() needs, below /learned.
  virtual void write(artefact::Writer& writer) const = 0;
};

/// Where write() writes.
inline constexpr const char* learned = "/learned";

/// The course of a training; empty where nothing is trained.
struct Training {
  std::vector<double> loss;            ///< [epochs] mean cross-entropy over the epoch's windows
  std::vector<double> train_accuracy;  ///< [epochs] in [0, 1]; each window before its own update
  double seconds = 0;                  ///< time of the epochs, without start-up and test
};

struct Learned {
  std::unique_ptr<Trained> trained;
  Training training;
};

/// Called after every epoch with the number of epochs done and the loss of the last.
using EpochDone = std::function<void(std::int64_t done, double loss)>;

/// Windows as WDCNN sees them, in which `what` names the set in errors.
using Represent = LabelledWindows (*)(const signal::WindowSet& windows, const std::string& what);

/// A classifier of the catalogue. Its own file defines it (nearest.hpp).
struct Classifier {
  const char* name;   ///< the name in CLASSIFIERS, in folders and in tables
  const char* what;   ///< what it is, in one phrase
  const char* input;  ///< what it is shown of a window
  /// Makes what a WDCNN is shown; null for any other, which has `learn` and `read` instead.
  Represent represent = nullptr;
  /// True if it learns from healthy windows alone: it needs no fault window, known or generated,
  /// and is run with `none` only.
  bool rule = false;
  /// Learns, where it is not a WDCNN. `normal` is B, and `training` all that there is to learn
  /// from, B first.
  Learned (*learn)(const signal::WindowSet& normal, const signal::WindowSet& training,
                   const Stream& stream, const EpochDone& epoch_done) = nullptr;
  /// Reads what it wrote when it had learned from windows of that data set, `length` samples each.
  std::unique_ptr<Trained> (*read)(const artefact::Reader& reader, const signal::DatasetInfo& info,
                                   std::size_t length) = nullptr;
  std::int64_t own_epochs = 0;  ///< of its training, where it is trained and is not a WDCNN

  [[nodiscard]] bool trains() const { return represent != nullptr || own_epochs > 0; }
};

}  // namespace piae::diagnosis
