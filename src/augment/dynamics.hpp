#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

/// Method `dynamics` (paper, Section 4.5.3): solves eq. 13 with stiffness and damping from the
/// literature. Each window deviates slightly from these values. Only the RMS of the known windows
/// is used. Throws Error(usage) if the options give a load that cannot close the clearance.
class Dynamics final : public Method {
 public:
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  signal::SimulationOptions options_;
};

}  // namespace piae::augment
