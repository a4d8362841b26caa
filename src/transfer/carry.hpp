#pragma once

#include <vector>

#include "base/random.hpp"
#include "signal/window_set.hpp"
#include "transfer/comb.hpp"
#include "transfer/edges.hpp"
#include "transfer/healthy.hpp"
#include "transfer/journey.hpp"
#include "transfer/options.hpp"
#include "transfer/path.hpp"
#include "transfer/rhythm.hpp"
#include "transfer/strike_train.hpp"
#include "transfer/structure.hpp"

namespace piae::transfer {

/// A window that was made, and when its defect is struck, in s from its first sample.
struct Carried {
  std::vector<float> samples;
  std::vector<double> strikes_s;
  std::size_t goes_on_in = 0;  ///< the known window in which it ends; mostly that of its journey
};

/// Carries known fault windows to the tested condition. What belongs to the structure stays where
/// it is in Hz; what belongs to the shaft moves with its speed. A window is put together from
///   - how the machine answers one blow (structure.hpp), by a random transfer path (path.hpp);
///   - strikes at the period that follows from the geometry, as strong as in the known window, or
///     as in a load zone where another bearing is tested (strengths.hpp);
///   - both edges of the defect (edges.hpp), whose lag is the known one by the ratio of the
///     passages, with a small deviation;
///   - a background that is not struck.
/// Its mean square is that of the known window. With --response cut, the known window itself is
/// taken instead: its spectrum is divided by the known E(f) and multiplied by the tested one, and
/// what follows each strike is set to the new rhythm (rhythm.hpp).
/// Where defects of the tested condition have sizes that are not known, one is drawn, uniform in
/// its logarithm, between the smallest known of the class and the largest, and some way beyond.
/// Where nothing moves, since the known bearing is tested at the known speed, the known window is
/// turned round, and at a random moment goes on in one of its bearing, in the same rhythm and as
/// loud as it is (turning.hpp): there is nothing that could be better known.
class Carrier {
 public:
  /// `edges` are those of each known window. Both must outlive this. `healthy` is for
  /// --background-from healthy alone: throws Error(usage) where that lacks a tested condition.
  Carrier(const signal::WindowSet& known, const std::vector<Edges>& edges,
          const CarryOptions& options, std::vector<HealthySpectrum> healthy = {});

  /// One window, as long as the known ones.
  [[nodiscard]] Carried carry(const Journey& journey, Stream& random) const;

  /// The k and c of the strongest resonance with which the bearing of a known window answers.
  [[nodiscard]] const signal::DynamicParameters& ring(std::size_t known) const {
    return rings_[known];
  }

 private:
  /// What is drawn for one window.
  struct Draw {
    Rhythm rhythm;  ///< in the tested condition
    Path path;
  };

  [[nodiscard]] bool moves(const Journey& journey) const;
  [[nodiscard]] Draw draw(const Journey& journey, Stream& random) const;
  [[nodiscard]] double draw_size_mm(std::size_t known, Stream& random) const;
  [[nodiscard]] Strengths strengths_from() const;
  [[nodiscard]] std::vector<double> draw_strengths(const Journey& journey, const Rhythm& rhythm,
                                                   double frame_s, Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd answer(const Journey& journey, Stream& random) const;
  [[nodiscard]] Eigen::ArrayXd background(const Journey& journey, const Eigen::ArrayXd& answer,
                                          const Draw& draw, Stream& random) const;
  [[nodiscard]] Carried put_together(const Journey& journey, Stream& random) const;
  [[nodiscard]] Carried cut_and_set(const Journey& journey, Stream& random) const;
  [[nodiscard]] Carried turn(std::size_t known, Stream& random) const;
  [[nodiscard]] Carried as_loud_as_known(std::size_t known, StruckWindow window) const;
  [[nodiscard]] Carried carried(const StruckWindow& window, std::size_t goes_on_in) const;

  const signal::WindowSet& known_;
  const std::vector<Edges>& edges_;
  CarryOptions options_;
  Structure structure_;
  std::vector<HealthySpectrum> healthy_;
  std::vector<std::vector<std::size_t>> of_bearing_;  ///< for each known window all of its bearing
  std::vector<Comb> combs_;                           ///< of each known window
  std::vector<std::vector<double>>
      strengths_;  ///< of each known window, where they are taken from there
  std::vector<signal::DynamicParameters> rings_;  ///< of each known window, by its bearing
};

}  // namespace piae::transfer
