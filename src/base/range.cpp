#include "base/range.hpp"

#include <sstream>

namespace piae {

std::string Range::rule() const {
  std::ostringstream text;
  text << "must be from " << low << " to " << high << unit;
  return text.str();
}

}  // namespace piae
