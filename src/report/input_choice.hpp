#pragma once

#include <string>

namespace piae::report {

/// Which classifier a method is shown with: a choice that was made before, on other seeds.
struct InputChoice {
  std::string method;
  std::string classifier;
};

/// Reads "none=wdcnn-spectrum". Throws Error(usage) for what is not METHOD=CLASSIFIER, for a method
/// or a classifier that there is not, and for a classifier that does not train: it has no input to
/// choose, and stands beside all methods anyway.
InputChoice parse_input_choice(const std::string& word);

}  // namespace piae::report
