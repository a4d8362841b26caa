#pragma once

#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "transfer/comb.hpp"
#include "transfer/edges.hpp"
#include "transfer/journey.hpp"
#include "transfer/options.hpp"
#include "transfer/structure.hpp"

namespace piae::transfer {

/// Carries known fault windows to the tested condition. What belongs to the structure stays where
/// it is in Hz; what belongs to the shaft moves with its speed:
///   - the lag between both edges of the defect (edges.hpp): the spectrum is divided by the known
///     E(f) and multiplied by the tested one, whose lag is the known one by the ratio of the
///     passages, with a small deviation;
///   - the strength of high frequencies, which grows with the sharpness of the blow: at a doubled
///     speed by a power of the frequency that is drawn for each window;
///   - the transfer path, which is known to some dB (equaliser.hpp);
///   - the rhythm of the strikes (rhythm.hpp), whose period follows from the geometry.
/// Where defects of the tested condition have sizes that are not known, one is drawn, uniform in
/// its logarithm, between the smallest known of the class and the largest, and some way beyond.
class Carrier {
 public:
  /// `edges` are those of each known window. Both must outlive this.
  Carrier(const signal::WindowSet& known, const std::vector<Edges>& edges,
          const CarryOptions& options);

  /// One window, as long as the known ones.
  [[nodiscard]] std::vector<float> carry(const Journey& journey, Stream& random) const;

 private:
  [[nodiscard]] double draw_size_mm(Label label, Stream& random) const;
  [[nodiscard]] std::vector<double> recoloured(const Journey& journey, double size_mm,
                                               Stream& random) const;
  [[nodiscard]] std::vector<double> synthesised(const Journey& journey, double size_mm,
                                                Stream& random) const;
  [[nodiscard]] std::vector<double> in_rhythm(const Journey& journey,
                                              const std::vector<double>& samples,
                                              Stream& random) const;

  const signal::WindowSet& known_;
  const std::vector<Edges>& edges_;
  CarryOptions options_;
  std::vector<Comb> combs_;                     ///< of each known window
  std::vector<std::vector<double>> strengths_;  ///< of the strikes of each known window
  Structure structure_;
};

}  // namespace piae::transfer
