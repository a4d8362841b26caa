#pragma once

#include <optional>
#include <vector>

#include "inspection/check.hpp"

namespace piae::inspection {

/// A common factor between measured and expected lines of several records.
struct CommonFactor {
  double factor = 1;                        ///< measured over expected frequency
  std::vector<const RecordCheck*> records;  ///< the records that agree
};

/// Returns the factor by which the lines of most of these records are off, if there is one and none
/// of their lines stands out at its expected place. Each record must have a class with a measured
/// line. A wrong speed or sample rate moves all lines by the same factor, by more than the 2 % of
/// the line search.
///
/// Without a common cause, the strongest place of a record is equally likely any of 20 places, each
/// 4 % wide, from 2/3 to 3/2. Then m of R records agree with a chance of 20 C(R, m) / 20^m, which
/// must be below 1 %: three of three suffice. The records must have at least two fault types. The
/// line of another machine part has one frequency, and so a different factor for each fault type.
std::optional<CommonFactor> common_factor(const signal::DatasetInfo& info,
                                          const std::vector<const RecordCheck*>& records);

}  // namespace piae::inspection
