#pragma once

#include "augment/method.hpp"
#include "augment/spectral_fit.hpp"
#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

/// Settings of the method `physics`.
struct PhysicsOptions {
  signal::SimulationOptions simulation;
  FitOptions fit;
  int space_bins = 10;  ///< histogram bins of k and of c, as for PIAE-DT; open in the paper
};

void bind(const cli::Options& command, PhysicsOptions& options);

/// Method `physics`, Model 3 of the ablation (paper, Section 4.5.4): PIAE-DT without its
/// auto-encoder. Stiffness and damping are fitted to each known window by eq. 13 itself
/// (SpectralFit). Their joint histogram over all of C is the digital twin space (eqs 14 and 15).
/// Windows are solutions of eq. 13 with points drawn from this space.
class Physics final : public Method {
 public:
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  PhysicsOptions options_;
};

}  // namespace piae::augment
