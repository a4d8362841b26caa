#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// Methods `oversample` and `shift`, which repeat the known windows. They are controls: a method
/// that trains a generator must beat them. Window i of a class is its known window i mod n.
/// `oversample` copies it. `shift` shifts it circularly by a number of samples drawn uniformly from
/// {0, ..., length - 1}. Then the window starts at any shaft angle, as real windows do, but has a
/// seam where its end meets its beginning.
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
