#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "artefact/provenance.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::nets {

/// Something that is trained epoch by epoch, and whose whole state can be written to a file between
/// two epochs. The random numbers of an epoch come from a stream named after the epoch, so they
/// need no state.
class Trainee {
 public:
  virtual ~Trainee() = default;

  [[nodiscard]] virtual std::size_t epochs() const = 0;
  /// What an epoch takes, in any unit: for how far the training is, and the time left. What stands
  /// here is for trainings all of whose epochs take as long.
  [[nodiscard]] virtual double effort(std::size_t /*epoch*/) const { return 1; }
  /// Runs one epoch, counted from 0. Returns a note for the progress line, such as "loss 0.41".
  virtual std::string run_epoch(std::size_t epoch) = 0;
  virtual void write_state(artefact::Writer& writer) const = 0;
  virtual void read_state(const artefact::Reader& reader) = 0;
};

/// Where a training that may be interrupted leaves its state.
struct Checkpoint {
  std::filesystem::path path;         ///< the stage removes it once the model is in place
  artefact::Provenance provenance;    ///< a checkpoint of other inputs or options is not used
  double interval_s = 10;             ///< time between two checkpoints: what a kill -9 may cost
  std::function<bool()> interrupted;  ///< asked after each epoch whether to stop
};

/// Runs all epochs. Goes on from the checkpoint when there is one that the same inputs, options and
/// build left. A training that is interrupted after any epoch and continued gives bit for bit what
/// an uninterrupted one gives. Throws Error(interrupted) once the checkpoint of an interrupted
/// training is on the disk.
void run_epochs(Trainee& trainee, const Checkpoint& checkpoint);

}  // namespace piae::nets
