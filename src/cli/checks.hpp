#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/range.hpp"

namespace piae::cli {

/// Requirement on the value of an option. Checks of numbers reject NaN and infinity.
struct Check {
  std::string shown;  ///< name of the value in the help
  /// Returns what is wrong with a value as typed; empty if the value is good.
  std::function<std::string(const std::string& text)> refusal;
};

/// Accepts finite numbers for which `good` is true. `wanted` describes these numbers.
Check number(std::string shown, std::string wanted, std::function<bool(double)> good);

Check positive_number();
Check non_negative_number();
Check share();                                              ///< from 0 to 1
Check within(const Range& range);                           ///< a number in the range
Check natural_number();                                     ///< 0, 1, 2, ... 10^15
Check whole_number(std::int64_t least, std::int64_t most);  ///< both included
Check one_of(const std::vector<std::string>& words);

}  // namespace piae::cli
