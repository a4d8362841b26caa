#pragma once

#include <span>
#include <vector>

#include "augment/method.hpp"
#include "impacts/path.hpp"

namespace piae::augment {

/// Returns a window played `factor` times as fast: sample t is the window at start + factor t, to
/// less than one sample. All frequencies move with the speed, resonances too, although a machine's
/// resonances do not. The window is continued periodically, as in `shift`, and resampled by
/// signal/resample.hpp, so that fast playback does not alias. The result has the window's length.
/// `factor` must be positive and `start` inside the window; factor 1 is a circular shift.
std::vector<double> played(std::span<const float> window, std::size_t start, double factor);

/// Methods `resample` and `randomise`, the controls if the tested speed differs from the known one.
/// They know both speeds and nothing of bearings. Window i of a class is its known window i mod n,
/// circularly shifted by a random number of samples as in `shift`, and played at another speed.
/// `resample` plays it at the tested speed: this makes the impact rate right and the resonances
/// wrong. `randomise` draws a factor between 1 and the ratio of the speeds (uniform in its
/// logarithm) and adds a random transfer path, so that a classifier learns to rely on neither.
/// Within one condition, `resample` equals `shift`.
class Playback final : public Method {
 public:
  enum class Speed { tested, random };

  explicit Playback(Speed speed) : speed_(speed) {}

  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  cli::StoredOptions table();

  Speed speed_;
  impacts::EqualiserOptions equaliser_;
};

}  // namespace piae::augment
