#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// The known windows again: the honest company of every method that learns to make new ones. Window
/// i of a class is its known window i mod n, as it is (`oversample`), or shifted circularly by a
/// number of samples drawn uniformly from {0, ..., length - 1} (`shift`): then a window starts at
/// any angle of the shaft, as real ones do, and has a seam where its end meets its beginning.
class Repetition final : public Method {
 public:
  enum class Shift { none, circular };

  explicit Repetition(Shift shift) : shift_(shift) {}

  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  Shift shift_;
};

}  // namespace piae::augment
