#pragma once

#include "augment/method.hpp"
#include "augment/spectral_fit.hpp"
#include "cli/options.hpp"
#include "signal/window_simulation.hpp"

namespace piae::augment {

struct PhysicsOptions {
  signal::SimulationOptions simulation;
  FitOptions fit;
  int space_bins = 10;  ///< of the histogram, for k and for c, as for PIAE-DT; open in the paper
};

void bind(const cli::Options& command, PhysicsOptions& options);

/// Model 3 of the ablation (paper, Section 4.5.4): PIAE-DT without its auto-encoder. Stiffness and
/// damping of each known window are fitted by eq. 13 itself (SpectralFit), their joint histogram
/// over all of C is the digital twin space (eqs 14 and 15), and windows are eq. 13 solved with
/// points drawn from it.
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
