#include "nets/trainee.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/one_line.hpp"
#include "base/sha256.hpp"
#include "cli/progress.hpp"

namespace piae::nets {

namespace {

const std::string checkpoint_kind = "checkpoint";

/// Returns a digest of everything that must be equal so that a continued training equals an
/// uninterrupted one.
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

/// Returns the number of epochs in the checkpoint. Returns 0, with a warning, if the checkpoint is
/// of other inputs, options or another build: the training then starts from the beginning.
std::size_t epochs_saved(const artefact::Reader& reader, const Trainee& trainee,
                         const Checkpoint& checkpoint) {
  if (reader.text("/", "identity") != identity_of(checkpoint.provenance)) {
    spdlog::warn(
        "{}: comes from other inputs, options or another build; training starts again at epoch 1",
        checkpoint.path.string());
    return 0;
  }
  const Range epochs{.low = 0, .high = static_cast<double>(trainee.epochs())};
  return static_cast<std::size_t>(reader.integer("/", "epochs_done", epochs));
}

std::optional<artefact::Reader> open_checkpoint(const Checkpoint& checkpoint) {
  if (!std::filesystem::exists(checkpoint.path)) return std::nullopt;
  try {
    return artefact::Reader(checkpoint.path, checkpoint_kind);
  } catch (const artefact::Refusal& refusal) {
    spdlog::warn("{}; training starts again at epoch 1", one_line(refusal.what()));
    return std::nullopt;
  }
}

/// Restores the state of the checkpoint; returns the number of finished epochs. Throws if a
/// complete checkpoint of this training holds an impossible state: no stage writes one, and part of
/// it may already have been restored.
std::size_t resume(Trainee& trainee, const Checkpoint& checkpoint) {
  const std::optional<artefact::Reader> reader = open_checkpoint(checkpoint);
  if (!reader) return 0;
  const std::size_t done = epochs_saved(*reader, trainee, checkpoint);
  if (done == 0) return 0;
  trainee.read_state(*reader);
  spdlog::info("going on from {} after {} epochs", checkpoint.path.string(), done);
  return done;
}

/// Returns the effort of all epochs before each one, and finally the total effort.
std::vector<double> efforts_of(const Trainee& trainee) {
  std::vector<double> efforts{0};
  for (std::size_t epoch = 0; epoch < trainee.epochs(); ++epoch) {
    efforts.push_back(efforts.back() + trainee.effort(epoch));
  }
  return efforts;
}

}  // namespace

void run_epochs(Trainee& trainee, const Checkpoint& checkpoint) {
  using Clock = std::chrono::steady_clock;
  const std::size_t first = resume(trainee, checkpoint);
  std::optional<cli::Progress> progress;
  const auto begin = [&](std::size_t done) {
    progress.emplace("train", "epochs", efforts_of(trainee), done);
  };
  if (first == 0) begin(0);
  Clock::time_point saved = Clock::now();
  for (std::size_t epoch = first; epoch < trainee.epochs(); ++epoch) {
    const std::string note = trainee.run_epoch(epoch);
    if (progress) progress->update(epoch + 1, note);
    // Start timing after the first resumed epoch, which may recompute what the state does not hold.
    if (!progress) begin(epoch + 1);
    if (checkpoint.interrupted()) {
      save(trainee, checkpoint, epoch + 1);
      throw Error(Exit::interrupted, "interrupted after epoch " + std::to_string(epoch + 1) +
                                         "; run the same command again to continue from " +
                                         checkpoint.path.string());
    }
    if (std::chrono::duration<double>(Clock::now() - saved).count() >= checkpoint.interval_s) {
      save(trainee, checkpoint, epoch + 1);
      saved = Clock::now();
    }
  }
}

}  // namespace piae::nets
