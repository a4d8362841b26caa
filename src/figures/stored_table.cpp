#include "figures/stored_table.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace piae::figures {

const std::string& StoredTable::at(std::size_t row, const std::string& column) const {
  const std::vector<std::string>& header = lines_.front().fields;
  const auto found = std::ranges::find(header, column);
  if (found == header.end()) {
    throw Error(Exit::bad_input, path_.string() + ": has no column '" + column + "'");
  }
  return lines_[row + 1].fields[static_cast<std::size_t>(found - header.begin())];
}

}  // namespace piae::figures
