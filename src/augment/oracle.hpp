#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// A ceiling, not a method: real windows in the place of generated ones, as though the faults had
/// been recorded for long enough. They are those of D, which no method may see; those of a class
/// come in an order drawn at random, since a blocked split has them in order of time. None comes
/// twice: more than there are is Error(usage).
class Oracle final : public Method {
 public:
  [[nodiscard]] LearnsFrom learns_from() const override { return LearnsFrom::real; }
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& real, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;
};

}  // namespace piae::augment
