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

/// Carries known fault windows to the tested condition. What belongs to the structure stays where
/// it is in Hz; what belongs to the shaft moves with its speed. A window is put together from
///   - the response of the machine to one impact (structure.hpp), by a random transfer path
///     (path.hpp);
///   - impacts at the period that follows from the geometry, as strong as in the known window, or
///     as in a load zone if another bearing is tested (strengths.hpp);
///   - both edges of the defect (impacts/edges.hpp), whose lag is the known one by the ratio of the
///     passages, with a small deviation;
///   - a background that is not struck.
/// Its mean square is that of the known window. With --response cut, the known window itself is
/// taken instead: its spectrum is divided by the known E(f) and multiplied by the tested one, and
/// what follows each impact is set to the new rate (cutting.hpp).
/// If defects of the tested condition have unknown sizes, one is drawn, uniform in its logarithm,
/// between the smallest known of the class and the largest, and some way beyond.
/// If nothing moves, because the known bearing is tested at the known speed, the known window is
/// circularly shifted, and at a random moment continues in one of its bearing, at the same rate and
/// level (turning.hpp): no model could know more.
class Carrier {
 public:
  /// `edges` are those of each known window. Both must outlive this. `healthy` is for
  /// --background-from healthy alone: throws Error(usage) where that lacks a tested condition.
  Carrier(const signal::WindowSet& known, const std::vector<impacts::Edges>& edges,
          const CarryOptions& options, std::vector<HealthySpectrum> healthy = {});

  /// One window, as long as the known ones. It knows its impacts, its condition, the known windows
  /// in which it begins and ends, and the k and c of the strongest resonance of its bearing.
  [[nodiscard]] signal::MadeWindow carry(const Journey& journey, Stream& random) const;

 private:
  struct KnownWindow {
    std::vector<std::size_t> alike;  ///< all known windows of its bearing
    signal::DynamicParameters ring;  ///< of its bearing
    Comb comb;
    std::vector<double> strengths;  ///< of its impacts
  };
  /// What is drawn for one window.
  struct Draw {
    impacts::ImpactRate rate;  ///< in the tested condition, in s
    impacts::Edges edges;      ///< in the tested condition
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
  [[nodiscard]] StruckWindow put_together(const Journey& journey, Stream& random) const;
  [[nodiscard]] StruckWindow cut_and_set(const Journey& journey, Stream& random) const;
  void match_level(std::size_t known, std::vector<double>& samples) const;

  const signal::WindowSet& known_;
  const std::vector<impacts::Edges>& edges_;
  CarryOptions options_;
  Structure structure_;
  std::vector<HealthySpectrum> healthy_;
  std::vector<KnownWindow> windows_;
};

}  // namespace piae::transfer
