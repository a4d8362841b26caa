#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

/// Lines of a suspect record that its healthy record does not have, over orders (multiples of the
/// shaft's frequency), without any knowledge of the bearing.
namespace piae::inspection {

/// Least number of turns of the shaft that resolve the lines.
inline constexpr double fewest_turns_for_orders = 50;

/// Returns the power of the whole record's envelope (spectra/whole_band_envelope.hpp), in dB above
/// its running median over 0.8 orders, at every hundredth of an order up to 70, or up to the end of
/// the spectrum. Each value is the highest bin within the hundredth. Uses 2^19 samples at most,
/// from the start. Empty for fewer than 50 turns and for a constant signal.
Eigen::ArrayXd order_lines_db(std::span<const double> signal, double rate_hz, double shaft_hz);

/// Excess of a suspect record over its healthy record.
class OrderExcess {
 public:
  /// Takes order_lines_db() of both records. Lines up to 0.02 orders from a line of the healthy
  /// record are lowered by that line. The excess is limited to 0 .. 45 dB, so that one line cannot
  /// replace many.
  OrderExcess(const Eigen::ArrayXd& suspect, const Eigen::ArrayXd& healthy, double shaft_hz);

  /// Returns the mean excess at the harmonics 1 .. `count` of an order, in dB; with `step` 2 at the
  /// odd ones alone. Leaves out harmonics within 0.03 orders of multiples of half the shaft's speed
  /// or of mains, which have other causes. Harmonics beyond the last order count as 0, because few
  /// harmonics are weak evidence. Empty if fewer than half of the harmonics are left.
  [[nodiscard]] std::optional<double> comb_db(double order, int count, int step = 1) const;

  /// Returns the mean excess in dB at h `order` ± `distance`, for h = 1 .. 6. A distance of 0 means
  /// the harmonics themselves, all of them.
  [[nodiscard]] double side_bands_db(double order, double distance) const;

  /// True if the shaft, looseness (half orders) or mains of 50 or 60 Hz may make a line here.
  [[nodiscard]] bool may_be_foreign(double order) const;

 private:
  [[nodiscard]] double at(double order) const;
  [[nodiscard]] bool is_near_mains(double order) const;

  Eigen::ArrayXd excess_db_;
  double shaft_hz_;
};

}  // namespace piae::inspection
