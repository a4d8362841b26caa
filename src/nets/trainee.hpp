#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "artefact/provenance.hpp"
#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::nets {

/// Something that is trained epoch by epoch, and whose whole state can be put away between two
/// epochs. Random numbers of an epoch come from a stream named after it, so they need no state.
class Trainee {
 public:
  virtual ~Trainee() = default;

  [[nodiscard]] virtual std::size_t epochs() const = 0;
  /// Runs one epoch (from 0); returns a note for the progress line, such as "loss 0.41".
  virtual std::string run_epoch(std::size_t epoch) = 0;
  virtual void write_state(artefact::Writer& writer) const = 0;
  virtual void read_state(const artefact::Reader& reader) = 0;
};

/// Where a training that may be cut leaves its state.
struct Checkpoint {
  std::filesystem::path path;         ///< removed by the stage once the model is in place
  artefact::Provenance provenance;    ///< a checkpoint of other inputs or options is not used
  double interval_s = 10;             ///< how much work a kill -9 may cost
  std::function<bool()> interrupted;  ///< asked after each epoch
};

/// Runs all epochs, going on from the checkpoint when there is one of the same inputs, options and
/// build. A training that is cut at any epoch and continued gives bit for bit what an uncut one
/// gives. Throws Error(interrupted) once a requested checkpoint is on the disk.
void run_epochs(Trainee& trainee, const Checkpoint& checkpoint);

}  // namespace piae::nets
