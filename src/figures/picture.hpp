#pragma once

#include <string>

#include "figures/numbers.hpp"

namespace piae::figures {

/// A picture of a figure that has several. Its files are FIGURE@PART.csv, .svg and .pdf.
struct Picture {
  std::string part;  ///< content, such as a class
  Numbers numbers;
};

}  // namespace piae::figures
