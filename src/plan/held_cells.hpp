#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan/experiment.hpp"
#include "plan/grid_steps.hpp"

namespace piae::plan {

/// A file of the grid that a run holds.
struct HeldCell {
  enum class Kind { model, score, diagnosis };
  Kind kind;
  std::int64_t seed;
  Variant variant;
  std::string ratio = {};       ///< of a diagnosis
  std::string classifier = {};  ///< of a diagnosis
};

/// Recognises the cells among the files of a data set's folder, which are given relative to it:
/// "seed0/smote/score.h5". What is no cell of the experiment as it is now is left out.
std::vector<HeldCell> held_cells(const Experiment& experiment,
                                 const std::vector<std::string>& files);

/// The points of a sweep as folders, and those of the readings.
std::string sweep_folder(const std::string& method, const std::string& point);
std::string reading_folder(const std::string& reading);
/// The settings of a reading: its own, and those of the base that it does not say otherwise.
std::vector<settings::Point> settings_of_reading(const Experiment& experiment,
                                                 const std::string& reading);

}  // namespace piae::plan
