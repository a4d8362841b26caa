#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "phase/options.hpp"

namespace piae::augment {

/// Method `piae-dt-phase`: PIAE-DT with the start angle in its twin space (src/phase). The
/// requested back end and device compute its decoder. Our own back end always infers (k, c), on the
/// CPU.
class PiaeDtPhase final : public Method {
 public:
  [[nodiscard]] bool needs_libtorch(const Compute& compute) const override;
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;
  std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                               const signal::WindowSet& windows,
                                               const Compute& compute) override;

 private:
  phase::PhaseOptions options_;
};

}  // namespace piae::augment
