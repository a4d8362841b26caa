#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"
#include "twin/options.hpp"
#include "twin/variant.hpp"

namespace piae::augment {

/// The paper's method `piae-dt` (src/twin), and its ablations that differ in one part of the twin.
/// All have the same options, even if an ablation ignores some, so that they can share settings.
class PiaeDt final : public Method {
 public:
  explicit PiaeDt(const twin::TwinVariant& variant) : variant_(variant) {}

  [[nodiscard]] bool needs_libtorch(const Compute& compute) const override;

  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;
  std::vector<signal::DynamicParameters> infer(const artefact::Reader& model,
                                               const signal::WindowSet& windows,
                                               const Compute& compute) override;

 private:
  twin::TwinVariant variant_;
  twin::TwinOptions options_;
};

}  // namespace piae::augment
