#pragma once

#include <vector>

#include "augment/method.hpp"
#include "transfer/healthy.hpp"
#include "transfer/options.hpp"

namespace piae::augment {

/// Method `strike-twin`, which makes fault windows of a condition in which no fault is known
/// (docs/strike-twin.md). The structure's response is that of the known windows. The bearing's
/// geometry and the tested speed give the times, rate and durations of the impacts.
class StrikeTwin final : public Method {
 public:
  void use_healthy(const signal::WindowSet& healthy) override;
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  transfer::CarryOptions options_;
  std::vector<transfer::HealthySpectrum> healthy_;
};

}  // namespace piae::augment
