#pragma once

#include <string>
#include <vector>

namespace piae::report {

/// One line of comma-separated values (RFC 4180, but ended by a line feed alone): a field with a
/// comma, a quote or a line feed in it is quoted.
std::string csv_line(const std::vector<std::string>& fields);

}  // namespace piae::report
