#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "artefact/writer.hpp"
#include "base/label.hpp"
#include "diagnosis/wdcnn_backend.hpp"
#include "signal/window_set.hpp"

namespace piae::diagnosis {

/// A classifier that has learned, whatever it is, and can be asked about windows of its data set.
class Trained {
 public:
  virtual ~Trained() = default;

  /// What it makes of each window. `what` names the set in errors, such as "--test". Of what has no
  /// hidden layer there is none. Throws Error(bad_input) for windows that it cannot be asked about.
  virtual WdcnnOutputs outputs(const signal::WindowSet& windows, const std::string& what) = 0;

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

/// [n] the class with the highest score, of scores row-major [n, classes].
std::vector<Label> most_likely(std::span<const float> scores, std::size_t classes);

}  // namespace piae::diagnosis
