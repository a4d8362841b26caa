#pragma once

#include "augment/method.hpp"
#include "twin/options.hpp"

namespace piae::augment {

/// The paper's method (src/twin) as an entry of the grid.
class PiaeDt final : public Method {
 public:
  void bind(CLI::App& app) override;
  void train(const signal::WindowSet& known, const Stream& stream, const std::string& device,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const std::string& device) override;

 private:
  twin::TwinOptions options_;
};

}  // namespace piae::augment
