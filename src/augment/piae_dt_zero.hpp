#pragma once

#include <optional>

#include "augment/method.hpp"
#include "zero/prior.hpp"

namespace piae::augment {

/// Method `piae-dt-zero`, which makes fault windows without known ones (docs/piae-dt-zero.md). It
/// uses C's description of the machine, even if C is empty, and healthy windows B as background. A
/// prior gives the rest.
class PiaeDtZero final : public Method {
 public:
  void use_healthy(const signal::WindowSet& healthy) override { healthy_ = healthy; }
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
