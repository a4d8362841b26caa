#pragma once

#include <optional>

#include "augment/method.hpp"
#include "zero/prior.hpp"

namespace piae::augment {

/// The method `piae-dt-zero`, which makes fault windows where no fault window is known:
/// docs/piae-dt-zero.md. Of the known windows it takes what they say of the machine, and none need
/// be there; of healthy windows B, what the machine sounds like. The rest is a prior.
class PiaeDtZero final : public Method {
 public:
  void hear(const signal::WindowSet& healthy) override { healthy_ = healthy; }
  void bind(const cli::Options& command) override { zero::table_of(prior_).bind(command); }
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  zero::Prior prior_;
  std::optional<signal::WindowSet> healthy_;
};

}  // namespace piae::augment
