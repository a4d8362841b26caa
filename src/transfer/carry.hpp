#pragma once

#include <vector>

#include "base/random.hpp"
#include "impacts/edges.hpp"
#include "impacts/times.hpp"
#include "transfer/comb.hpp"
#include "transfer/cutting.hpp"
#include "transfer/healthy.hpp"
#include "transfer/journey.hpp"
#include "transfer/options.hpp"
#include "transfer/path.hpp"
#include "transfer/structure.hpp"

namespace piae::transfer {

/// Carries known fault windows to the tested condition. The structure's part of a spectrum is fixed
/// in Hz; the shaft's part moves with the speed. A window consists of
///  - the response of the machine to one impact (structure.hpp), through a random transfer path
/// (path.hpp);
///  - impacts at the period that follows from the geometry, with the strengths of the known window,
/// or with those of a load zone if another bearing is tested (strengths.hpp);
///  - both edges of the defect (impacts/edges.hpp); their lag is the known one times the ratio of
/// the passages, with a small deviation;
///  - a background that impacts do not excite.
/// Its mean square is that of the known window. With --response cut, the known window itself is
/// used instead: its spectrum is divided by the known E(f) and multiplied by the tested one, and
/// the response to each impact is moved to the new rate (cutting.hpp).
/// If defects of the tested condition have unknown sizes, a size is drawn, log-uniform, between the
/// smallest and the largest known size of the class, extended by a factor.
/// If nothing moves, because the known bearing is tested at the known speed, the known window is
/// circularly shifted. At a random moment it continues in another window of its bearing, at the
/// same rate and level (endless_cycle.hpp). A model could not add information here.
class Carrier {
 public:
  /// `edges` are those of each known window. Both must outlive this. `healthy` is only for
  /// --background-from healthy. Throws Error(usage) if that option is set and `healthy` lacks a
  /// tested condition.
  Carrier(const signal::WindowSet& known, const std::vector<impacts::Edges>& edges,
          const CarryOptions& options, std::vector<HealthySpectrum> healthy = {});

  /// Returns one window, as long as the known ones. It records its impacts, its condition, the
  /// known windows in which it begins and ends, and the k and c of the strongest resonance of its
  /// bearing.
  [[nodiscard]] signal::MadeWindow carry(const Journey& journey, Stream& random) const;

 private:
  struct KnownWindow {
    std::vector<std::size_t> alike;  ///< all known windows of its bearing
    signal::DynamicParameters ring;  ///< strongest resonance of its bearing
    Comb comb;
    std::vector<double> strengths;  ///< strengths of its impacts
  };
  /// Values that are drawn for one window.
  struct Draw {
    impacts::ImpactRate rate;  ///< for the tested condition, in s
    impacts::Edges edges;      ///< for the tested condition
    Path path;
  };

  [[nodiscard]] bool moves(const Journey& journey) const;
  [[nodiscard]] Draw draw(const Journey& journey, Stream& random) const;
  [[nodiscard]] double draw_size_mm(std::size_t known, Stream& random) const;
  [[nodiscard]] Strengths strengths_from() const;
  [[nodiscard]] std::vector<double> draw_strengths(const Journey& journey, double period_s,
                                                   std::size_t count, Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd response(const Journey& journey, Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd background(const Journey& journey, const Eigen::ArrayXd& response,
                                          const Draw& draw, Stream& random) const;
  [[nodiscard]] ImpactWindow put_together(const Journey& journey, Stream& random) const;
  [[nodiscard]] ImpactWindow cut_and_set(const Journey& journey, Stream& random) const;
  void match_level(std::size_t known, std::vector<double>& samples) const;

  const signal::WindowSet& known_;
  const std::vector<impacts::Edges>& edges_;
  CarryOptions options_;
  Structure structure_;
  std::vector<HealthySpectrum> healthy_;
  std::vector<KnownWindow> windows_;
};

}  // namespace piae::transfer
