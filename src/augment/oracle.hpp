#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// `oracle`, which is a ceiling and not a method: it gives real windows in the place of generated
/// ones, as if the faults had been recorded for long enough. They are the windows D, which no
/// method may see. Those of a class come in random order, because a blocked split has them in order
/// of time. No window comes twice; asking for more than there are throws Error(usage).
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
