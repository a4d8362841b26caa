#pragma once

#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "run/grid.hpp"

namespace piae::plan {

/// The cells of one data set that are asked for.
struct Part {
  Dataset dataset;
  std::vector<run::Combination> cells;  ///< methods and classifiers in the order asked for
  std::vector<std::string> methods;     ///< those that have a cell
};

/// What is asked for of every data set.
struct AskedOfAll {
  std::vector<std::string> methods;
  std::vector<std::string> ratios;
  std::vector<std::string> classifiers;
  bool methods_are_named = false;  ///< each must be possible
};

/// The cells of what is asked for that a data set can have. Adds to the notices, for people, what
/// is left out and why. Throws Error(usage) where nothing is left, or for a method that was named
/// and cannot be run with what the description says.
Part part_of(const Dataset& dataset, const AskedOfAll& asked, std::vector<std::string>& notices);

/// The methods of these that have cells at any of these ratios.
std::vector<std::string> with_ratios(const std::vector<std::string>& methods,
                                     const std::vector<std::string>& ratios);

}  // namespace piae::plan
