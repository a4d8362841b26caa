#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/range.hpp"

namespace piae::cli {

/// What the value of an option must be. No check of a number accepts NaN or infinity.
struct Check {
  std::string shown;  ///< what the help says of the value
  /// Says in words what is wrong with a value as it was typed; nothing where it is good.
  std::function<std::string(const std::string& text)> refusal;
};

/// A finite number for which `good` holds. `wanted` says in words which numbers these are.
Check number(std::string shown, std::string wanted, std::function<bool(double)> good);

Check positive_number();
Check non_negative_number();
Check share();                                              ///< from 0 to 1
Check within(const Range& range);                           ///< a number of the range
Check natural_number();                                     ///< 0, 1, 2, ... 10^15
Check whole_number(std::int64_t least, std::int64_t most);  ///< both included
Check one_of(const std::vector<std::string>& words);

}  // namespace piae::cli
