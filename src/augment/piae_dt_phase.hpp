#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "phase/options.hpp"

namespace piae::augment {

/// PIAE-DT with the start angle in its twin space (src/phase) as an entry of the grid.
class PiaeDtPhase final : public Method {
 public:
  static constexpr bool needs_libtorch = true;

  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const std::string& device,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const std::string& device) override;
  std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                               const signal::WindowSet& windows,
                                               const std::string& device) override;

 private:
  phase::PhaseOptions options_;
};

}  // namespace piae::augment
