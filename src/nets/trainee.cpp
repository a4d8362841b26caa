#include "nets/trainee.hpp"

#include <spdlog/spdlog.h>

#include <chrono>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "cli/progress.hpp"

namespace piae::nets {

namespace {

const std::string checkpoint_kind = "checkpoint";

/// A digest of all that must be the same for a continued training to equal an uninterrupted one.
std::string identity_of(const artefact::Provenance& provenance) {
  Sha256 sha;
  sha.update(artefact::build_version()).update(artefact::build_libraries());
  sha.update(artefact::cpu_settings()).update(provenance.program).update(provenance.options);
  for (const auto& input : provenance.inputs) sha.update(input.role).update(input.digest);
  return sha.finish_hex();
}

void save(const Trainee& trainee, const Checkpoint& checkpoint, std::size_t epochs_done) {
  artefact::Writer writer(checkpoint_kind);
  writer.attribute("/", "identity", identity_of(checkpoint.provenance));
  writer.attribute("/", "epochs_done", static_cast<std::int64_t>(epochs_done));
  trainee.write_state(writer);
  writer.save(checkpoint.path, checkpoint.provenance);
}

/// Restores the state that the checkpoint holds; returns how many epochs need not be run again. A
/// checkpoint that does not fit or is damaged is no error: the training starts anew, with a
/// warning.
std::size_t resume(Trainee& trainee, const Checkpoint& checkpoint) {
  if (!std::filesystem::exists(checkpoint.path)) return 0;
  try {
    const artefact::Reader reader(checkpoint.path, checkpoint_kind);
    if (reader.text("/", "identity") != identity_of(checkpoint.provenance)) {
      spdlog::warn("{}: is of other inputs, options or another build; training starts anew",
                   checkpoint.path.string());
      return 0;
    }
    trainee.read_state(reader);
    const auto done = static_cast<std::size_t>(reader.integer("/", "epochs_done"));
    spdlog::info("going on from {} after {} epochs", checkpoint.path.string(), done);
    return done;
  } catch (const artefact::Refusal& refusal) {
    spdlog::warn("{}; training starts anew", refusal.what());
    return 0;
  }
}

}  // namespace

void run_epochs(Trainee& trainee, const Checkpoint& checkpoint) {
  using Clock = std::chrono::steady_clock;
  const std::size_t first = resume(trainee, checkpoint);
  cli::Progress progress("train", "epochs", trainee.epochs(), first);
  Clock::time_point saved = Clock::now();
  for (std::size_t epoch = first; epoch < trainee.epochs(); ++epoch) {
    progress.update(epoch + 1, trainee.run_epoch(epoch));
    if (checkpoint.interrupted()) {
      save(trainee, checkpoint, epoch + 1);
      throw Error(Exit::interrupted, "interrupted after epoch " + std::to_string(epoch + 1) +
                                         "; the same command goes on from " +
                                         checkpoint.path.string());
    }
    if (std::chrono::duration<double>(Clock::now() - saved).count() >= checkpoint.interval_s) {
      save(trainee, checkpoint, epoch + 1);
      saved = Clock::now();
    }
  }
}

}  // namespace piae::nets
