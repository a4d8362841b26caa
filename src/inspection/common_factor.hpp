#pragma once

#include <optional>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

/// A factor by which the lines of several records are away from their places.
struct CommonFactor {
  double factor = 1;                        ///< where they are, over where they should be
  std::vector<const RecordCheck*> records;  ///< whose lines are there
};

/// Looks for one factor by which the lines of most of these records are off, and none of them
/// stands out at its place. Each record must be of a class with a line, and have it measured. A
/// wrong speed or a wrong sample rate moves all lines by the same factor, by more than the 2 %
/// within which lines are looked for.
///
/// Without a common reason, the farthest place of a record is as likely to be any of the 20 that
/// 2/3 to 3/2 holds, each 4 % wide. Then m of R records agree with a chance of
/// 20 C(R, m) / 20^m, which must be below 1 %: three of three do. They must be of two kinds, since
/// the line of another machine part has one frequency, and so another factor for each kind.
std::optional<CommonFactor> common_factor(const signal::DatasetInfo& info,
                                          const std::vector<const RecordCheck*>& records);

}  // namespace piae::inspection
