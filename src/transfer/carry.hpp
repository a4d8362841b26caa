#pragma once

#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "transfer/comb.hpp"
#include "transfer/edges.hpp"
#include "transfer/journey.hpp"
#include "transfer/options.hpp"
#include "transfer/path.hpp"
#include "transfer/structure.hpp"

namespace piae::transfer {

/// Carries known fault windows to the tested condition. What belongs to the structure stays where
/// it is in Hz; what belongs to the shaft moves with its speed. A window is put together from
///   - how the machine answers one blow (structure.hpp), by a random transfer path (path.hpp);
///   - strikes at the period that follows from the geometry, as strong as those of a known window
///     (strike_train.hpp);
///   - both edges of the defect (edges.hpp), whose lag is the known one by the ratio of the
///     passages, with a small deviation;
///   - a background that is not struck.
/// Its mean square is that of the known window. With --response cut, the known window itself is
/// taken instead: its spectrum is divided by the known E(f) and multiplied by the tested one, and
/// what follows each strike is set to the new rhythm (rhythm.hpp).
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
  /// What is drawn for one window.
  struct Draw {
    Edges edges;          ///< in the tested condition
    double period_s = 0;  ///< between strikes
    Path path;
  };

  [[nodiscard]] Draw draw(const Journey& journey, Stream& random) const;
  [[nodiscard]] double draw_size_mm(std::size_t known, Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd put_together(const Journey& journey, const Draw& draw,
                                            Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd cut_and_set(const Journey& journey, const Draw& draw,
                                           Stream& random) const;

  const signal::WindowSet& known_;
  const std::vector<Edges>& edges_;
  CarryOptions options_;
  Structure structure_;
  std::vector<Comb> combs_;                     ///< of each known window
  std::vector<std::vector<double>> strengths_;  ///< of the strikes of each known window
};

}  // namespace piae::transfer
