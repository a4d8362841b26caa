#pragma once

#include <span>
#include <vector>

#include "augment/method.hpp"
#include "impacts/path.hpp"

namespace piae::augment {

/// A window played `factor` times as fast: sample t is the window at start + factor t, to less than
/// one sample. Everything in it moves with the speed, the resonances too, which in a machine stay.
/// It continues with its beginning where it ends, as with the method `shift`, and is resampled by
/// signal/resample.hpp, so that playing fast folds nothing over. The result is as long as the
/// window. `factor` must be positive and `start` within the window; a factor of 1 shifts it
/// circularly.
std::vector<double> played(std::span<const float> window, std::size_t start, double factor);

/// The methods `resample` and `randomise`. They are controls where the tested condition has another
/// speed than the known one: they know both speeds and nothing of bearings. Window i of a class is
/// its known window i mod n, turned round by a random number of samples as with `shift`, and
/// played at another speed. `resample` plays it at the tested speed: the rhythm of the strikes is
/// then right, the resonances are not. `randomise` plays it by a factor drawn between 1 and the
/// ratio of the speeds (uniform in its logarithm) and gives it a random transfer path: a classifier
/// may learn from that to rely on neither. In one condition, `resample` is `shift`.
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
