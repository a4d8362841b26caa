#pragma once

#include <vector>

#include "augment/interpolation.hpp"
#include "augment/method.hpp"
#include "impacts/path.hpp"

namespace piae::augment {

/// Returns a window with the same amplitude spectrum and phases drawn uniformly, bin by bin. The
/// bins at 0 Hz and at half the sampling rate, which are real, stay as they are.
std::vector<double> with_random_phases(Window window, Stream& random);

/// Method `spectral`: the spectrum of a known window, in turn, with random phases, through a random
/// transfer path as in `randomise`. It keeps what a spectrum shows, and no impact times. The RMS is
/// that of the known window.
class Spectral final : public Method {
 public:
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  cli::StoredOptions table();

  impacts::EqualiserOptions equaliser_;
};

}  // namespace piae::augment
