#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace piae::cli {

/// What the text of an option's value must be. No number check lets NaN or infinity pass.
struct Check {
  std::string shown;                                            ///< in the help
  std::function<std::string(const std::string& text)> refusal;  ///< in words; empty when it is good
};

/// A finite number for which `good` holds; `wanted` says in words which these are.
Check number(std::string shown, std::string wanted, std::function<bool(double)> good);

Check positive_number();
Check non_negative_number();
Check share();           ///< from 0 to 1
Check natural_number();  ///< 0, 1, 2, ... 10^15
Check whole_number(std::int64_t least, std::int64_t most);
Check one_of(const std::vector<std::string>& words);

}  // namespace piae::cli
