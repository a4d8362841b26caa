#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "latent/backend.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"

namespace piae::latent {

/// Trains a LatentGenerator and its second network in batches of the known windows C. The back end
/// computes the steps; this class does everything else. Order and noise of epoch i come from the
/// stream's child "epoch<i>".
class LatentTraining final : public nets::Trainee {
 public:
  using MakeBackend =
      std::function<std::unique_ptr<LatentBackend>(LatentTask task, const Stream& initial)>;

  /// `losses` names the values that a step returns. Throws Error(bad_input) if a class of C is
  /// silent.
  LatentTraining(const signal::WindowSet& known, const LatentOptions& options,
                 const std::vector<std::string>& losses, const Stream& stream,
                 const MakeBackend& make_backend);

  [[nodiscard]] std::size_t epochs() const override;
  /// Throws Error(failed) if a loss is not finite.
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  /// Writes the generator after the last epoch, with the whole state of the training: weights,
  /// Adam, /curves/<loss>.
  void write_model(artefact::Writer& writer) const;

 private:
  struct Curve {
    std::string loss;
    std::vector<double> means;  ///< over the steps of each epoch
  };
  std::string note_epoch(std::size_t epoch, const std::vector<double>& means);

  Stream stream_;
  LatentOptions options_;
  LatentGenerator generator_;
  std::size_t windows_;  ///< number of known windows
  std::unique_ptr<LatentBackend> backend_;
  std::vector<Curve> curves_;
};

}  // namespace piae::latent
