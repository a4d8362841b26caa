#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

struct SmoteOptions {
  int neighbours = 4;  ///< k. Chawla et al. take 5; with five known windows 4 is all there are
};

void bind(const cli::Options& command, SmoteOptions& options);

/// SMOTE (Chawla et al. 2002, "SMOTE: synthetic minority over-sampling technique"): a generated
/// window lies on the line from a known window of the class to one of its k nearest of that class,
/// at a place drawn uniformly. As there, the known windows take turns to be the base, so that each
/// is used equally often. One gap serves all samples of a window, as their text has it (a line) and
/// their listing, which draws one for each attribute, has not.
/// The model holds the known windows; k above n - 1 is Error(usage).
class Smote final : public Method {
 public:
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  SmoteOptions options_;
};

}  // namespace piae::augment
