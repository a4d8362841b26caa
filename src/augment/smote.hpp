#pragma once

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// The settings of SMOTE.
struct SmoteOptions {
  int neighbours =
      4;  ///< k. Chawla et al. take 5, but of five known windows each has only 4 others
};

void bind(const cli::Options& command, SmoteOptions& options);

/// The method `smote` (Chawla et al. 2002, "SMOTE: synthetic minority over-sampling technique"): a
/// generated window lies on the line from a known window of its class to one of the k known windows
/// of the class that are nearest to it, at a place drawn uniformly. As in the paper by Chawla et
/// al., each known window is the starting point equally often. All samples of a window use one gap,
/// as their text says (a point on the line); their listing draws one for each sample instead.
/// The model holds the known windows. Throws Error(usage) for k above n - 1.
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
