#pragma once

#include <optional>

#include "augment/method.hpp"
#include "zero/impulses.hpp"

namespace piae::augment {

/// Method `healthy-plus-impulses`, the usual recipe if no fault window is known
/// (zero/impulses.hpp). It is the control that piae-dt-zero must beat.
class HealthyPlusImpulses final : public Method {
 public:
  void use_healthy(const signal::WindowSet& healthy) override { healthy_ = healthy; }
  void bind(const cli::Options& command) override { zero::table_of(options_).bind(command); }
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  zero::ImpulseOptions options_;
  std::optional<signal::WindowSet> healthy_;
};

}  // namespace piae::augment
