#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "artefact/provenance.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::nets {

/// A model that is trained epoch by epoch. Its whole state can be written to a file between two
/// epochs. The random numbers of an epoch come from a stream named after the epoch, so they are not
/// part of the state.
class Trainee {
 public:
  virtual ~Trainee() = default;

  [[nodiscard]] virtual std::size_t epochs() const = 0;
  /// Returns the cost of an epoch, in any unit, for the progress and the remaining time. The
  /// default is for trainings whose epochs all take the same time.
  [[nodiscard]] virtual double effort(std::size_t /*epoch*/) const { return 1; }
  /// Runs one epoch, counted from 0. Returns a note for the progress line, such as "loss 0.41".
  virtual std::string run_epoch(std::size_t epoch) = 0;
  virtual void write_state(artefact::Writer& writer) const = 0;
  virtual void read_state(const artefact::Reader& reader) = 0;
};

/// File to which a training that may be interrupted saves its state.
struct Checkpoint {
  std::filesystem::path path;       ///< the stage removes it once the model is in place
  artefact::Provenance provenance;  ///< a checkpoint of other inputs or options is not used
  double interval_s = 10;  ///< time between two checkpoints: the most that a kill -9 may cost
  std::function<bool()> interrupted;  ///< called after each epoch; true stops the training
};

/// Runs all epochs. Continues from the checkpoint if the same inputs, options and build wrote it. A
/// training that is interrupted after any epoch and continued gives bit for bit the result of an
/// uninterrupted one. Throws Error(interrupted) once the checkpoint of an interrupted training is
/// on the disk.
void run_epochs(Trainee& trainee, const Checkpoint& checkpoint);

}  // namespace piae::nets
