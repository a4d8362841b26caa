#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "latent/backend.hpp"
#include "nets/trainee.hpp"
#include "signal/window_set.hpp"

namespace piae::latent {

/// The training of a LatentGenerator and the network beside it, in batches of the known windows C:
/// everything but the step itself, which is the back end's. Order and noise of epoch i come from
/// the stream's child "epoch<i>".
class LatentTraining final : public nets::Trainee {
 public:
  using MakeBackend =
      std::function<std::unique_ptr<LatentBackend>(LatentTask task, const Stream& initial)>;

  /// `losses` names what a step returns. Throws Error(bad_input) when a class of C is silent.
  LatentTraining(const signal::WindowSet& known, const LatentOptions& options,
                 const std::vector<std::string>& losses, const Stream& stream,
                 const MakeBackend& make_backend);

  [[nodiscard]] std::size_t epochs() const override;
  /// Throws Error(failed) when a loss is no longer finite.
  std::string run_epoch(std::size_t epoch) override;
  void write_state(artefact::Writer& writer) const override;
  void read_state(const artefact::Reader& reader) override;

  /// Writes the generator as it is after the last epoch, with the whole state of the training:
  /// weights, Adam, /curves/<loss>.
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
  std::size_t windows_;  ///< known ones
  std::unique_ptr<LatentBackend> backend_;
  std::vector<Curve> curves_;
};

}  // namespace piae::latent
