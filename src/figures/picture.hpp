#pragma once

#include <string>

#include "figures/numbers.hpp"

namespace piae::figures {

/// One picture of a figure that has several. Its files are FIGURE@PART.csv, .svg and .pdf.
struct Picture {
  std::string part;  ///< what it shows, such as a class
  Numbers numbers;
};

}  // namespace piae::figures
