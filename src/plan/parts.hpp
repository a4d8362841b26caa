#pragma once

#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "run/grid.hpp"

namespace piae::plan {

/// The requested cells of one data set.
struct Part {
  Dataset dataset;
  std::vector<run::Combination> cells;  ///< in the requested order of methods and classifiers
  std::vector<std::string> methods;     ///< methods that have a cell
};

/// The request for every data set.
struct RequestedForAll {
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> classifiers;
  bool methods_are_named = false;  ///< every method must be possible
};

/// Methods or classifiers left out of one data set, and why.
struct Notice {
  std::string dataset;
  std::string text;
};
using Notices = std::vector<Notice>;

/// Returns a line for each text, with the first of its data sets and the number of the others.
std::vector<std::string> notice_lines(const Notices& notices);

/// Returns the requested cells that a data set can have. Adds to `notices` what is left out, and
/// why. Throws Error(usage) if nothing is left, or if a named method needs more than the
/// description contains.
Part part_of(const Dataset& dataset, const RequestedForAll& requested, Notices& notices);

/// Returns the methods that have cells at any of these ratios.
std::vector<std::string> with_ratios(const std::vector<std::string>& methods,
                                     const std::vector<std::string>& ratios);

}  // namespace piae::plan
