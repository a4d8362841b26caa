#include "signal/ranges.hpp"

#include <string_view>

namespace piae::signal::ranges {

bool is_plain_name(const std::string& name) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  constexpr std::size_t longest = 100;
  return !name.empty() && name.size() <= longest && name.front() != '.' &&
         name.find_first_not_of(allowed) == std::string::npos;
}

}  // namespace piae::signal::ranges
