#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// `oracle`, a ceiling and not a method: returns real windows instead of generated ones, as if the
/// faults had been recorded for long enough. They are the windows D, which no method may use. They
/// are shuffled within a class, because a blocked split stores them in order of time. No window is
/// repeated; a `count` above their number throws Error(usage).
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
