#pragma once

#include <vector>

#include "augment/interpolation.hpp"
#include "augment/method.hpp"
#include "cli/stored_options.hpp"

namespace piae::augment {

/// Settings of `mixup` and `aligned-mixup`.
struct MixupOptions {
  double alpha = 0.2;  ///< both shapes of lambda's Beta distribution; as Zhang et al. on ImageNet
};

/// Returns a window circularly shifted to the lag at which it correlates most with the reference,
/// and scaled to the reference's RMS. Of several such lags it takes one. The lengths must be equal
/// and neither window may be silent.
std::vector<float> aligned_to(Window reference, Window window);

/// Methods `mixup` (Zhang et al. 2018, "mixup: beyond empirical risk minimization") and
/// `aligned-mixup`. A generated window is lambda x_i + (1 - lambda) x_j, with lambda ~ Beta(alpha,
/// alpha), of two different known windows. Zhang et al. mix classes and their labels; here both
/// windows have the same class, because a generated window has one. The known windows take turns as
/// x_i, and x_j is drawn uniformly among the others. `aligned-mixup` first aligns x_j with x_i,
/// because windows that begin at different shaft angles cancel each other. Throws Error(bad_input)
/// if a class has one known window only.
class Mixup final : public Method {
 public:
  /// Selects x_j as it is known, or aligned_to(x_i).
  enum class Partner { as_known, aligned };

  explicit Mixup(Partner partner) : partner_(partner) {}

  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  cli::StoredOptions table();

  Partner partner_;
  MixupOptions options_;
};

}  // namespace piae::augment
