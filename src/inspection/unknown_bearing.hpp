#pragma once

#include <span>
#include <string>
#include <vector>

#include "inspection/order_excess.hpp"
#include "signal/bearing_table.hpp"

namespace piae::inspection {

/// Fault type that the lines of a record look like.
enum class Likeness { nothing, outer, inner, outer_or_inner, ball, cage };

/// Fault line of a bearing without known geometry.
struct UnknownLine {
  Likeness likeness = Likeness::nothing;  ///< nothing: no line can be named
  /// Multiple of the shaft's speed: BPFO, BPFI, 2 BSF or FTF; 0 if no line can be named.
  double order = 0;
  double db = 0;            ///< OrderExcess::comb_db() of the strongest line, named or not
  bool is_certain = false;  ///< high confidence
  /// Designations of known bearings with this line within 1 %.
  std::vector<std::string> bearings = {};
};

/// Returns the fault line that stands out of the healthy record, and what it looks like.
///
/// The line is the order from 2 to 16 with the highest mean excess at 10 harmonics, or its half if
/// the odd harmonics of that show, too. Usual bearings have 7 or more balls, and d cos(alpha) / D
/// from 0.15 to 0.4: no BPFO, BPFI or 2 BSF below 2. A side band of the shaft, h BPFI - h, lies
/// lower than h BPFI from the second harmonic on, so ten harmonics find the centre. Below 8 dB
/// nothing is named.
///
/// The likeness follows Randall and Antoni (2011, section 2) and the kinematics of a bearing:
///  - ball: side bands at the cage's order that 2 BSF implies for a contact angle of 0, stronger
///    than those of the shaft. A line at BSF is doubled;
///  - inner race: side bands of the shaft (1 or 2 orders away), and an order of at least 4, the
///    BPFI of 7 balls;
///  - outer race: no such side bands, or an order below 4;
///  - cage: no line of impacts, but harmonics of 0.3 to 0.46 orders. Never certain.
///
/// The confidence is high if the line exceeds 18 dB, its side bands are clear, `speed_is_certain`
/// (the signal shows its shaft speed), and a known bearing has this line. An inner race also needs
/// a line 2 dB above the combs one and two orders away, and no known bearing with this BPFO.
///
/// The thresholds were chosen on HIT-SM, CWRU's records at 0 hp and 60 simulated machines. Three
/// rules followed a first run on all records of CWRU, HIT-SM and UESTC: the lowest order of 2, the
/// certain speed, and that lines within 1 % of a multiple of the shaft's speed are not named.
UnknownLine unknown_line(const OrderExcess& excess, bool speed_is_certain,
                         std::span<const signal::BearingLines> known);

}  // namespace piae::inspection
