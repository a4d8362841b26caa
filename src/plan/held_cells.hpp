#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "plan/grid_steps.hpp"

namespace piae::plan {

/// A file of the grid that the run holds.
struct HeldCell {
  enum class Kind { model, score, diagnosis };
  Kind kind;
  std::int64_t seed;
  Variant variant;
  std::string ratio = {};       ///< diagnosis only
  std::string classifier = {};  ///< diagnosis only
};

/// Recognises the cells among the files of a data set's folder, given relative to it:
/// "seed0/smote/score.h5". Leaves out files that are not cells of the present experiment.
std::vector<HeldCell> held_cells(const Experiment& experiment,
                                 const std::vector<std::string>& files);

/// Return the folder of a point of a sweep, and of an interpretation.
std::string sweep_folder(const std::string& method, const std::string& point);
std::string reading_folder(const std::string& reading);
/// Returns the settings of an interpretation: its own, and the others of the base.
std::vector<settings::Point> settings_of_reading(const Experiment& experiment,
                                                 const std::string& reading);

}  // namespace piae::plan
