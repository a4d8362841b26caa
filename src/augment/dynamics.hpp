#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

/// The method `dynamics` (paper, Section 4.5.3): it solves eq. 13 with stiffness and damping from
/// the literature, each window with a small deviation of its own. Of the known windows it uses
/// nothing but their RMS. Throws Error(usage) for options with which the load cannot close the
/// clearance.
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
