#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// Settings of SMOTE.
struct SmoteOptions {
  int neighbours =
      4;  ///< k; Chawla et al. take 5, but with five known windows each has only 4 others
};

void bind(const cli::Options& command, SmoteOptions& options);

/// Method `smote` (Chawla et al. 2002, "SMOTE: synthetic minority over-sampling technique"). A
/// generated window lies on the line from a known window to one of its k nearest known windows of
/// the same class, at a uniformly drawn place. As in Chawla et al., each known window is the
/// starting point equally often. All samples of a window use one gap, as in their text (a point on
/// the line); their listing draws one gap for each sample. The model holds the known windows.
/// Throws Error(usage) for k above n - 1.
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
