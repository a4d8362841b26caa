#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "run/collect.hpp"
#include "run/layout.hpp"

namespace piae::page {

/// How far a cell is that is not there.
enum class HoleState {
  failed,       ///< a step on the way to it failed
  refused,      ///< it is there, but damaged, of another cell, or made under other conditions
  interrupted,  ///< a step was stopped; the same command goes on from there
  open,         ///< a step is running, or was killed
  not_begun
};

/// A cell of the grid that no number of a page includes, and why.
struct Hole {
  run::CellName name;  ///< the ratio is empty for a score
  HoleState state = HoleState::not_begun;
  std::string stage = {};          ///< the one that is not done; empty for a cell that is refused
  std::string why = {};            ///< of a cell that failed or is refused
  std::filesystem::path log = {};  ///< below the folder of the run; empty where there is none
};

/// What collecting a data set said of its files, by file: all its errors name one. There may be as
/// many as there are cells.
class ProblemsByFile {
 public:
  ProblemsByFile(const run::Layout& layout, const std::vector<std::string>& problems);
  /// Empty where nothing was said of it.
  [[nodiscard]] std::string with(const std::filesystem::path& file) const;

 private:
  std::map<std::string, std::string> problems_;
};

/// Why a cell has no number in the results. `problems` are those of collecting it. Paths are named
/// from the folder of the run on, so that the same holes read the same in any folder.
Hole hole_of(const std::filesystem::path& run, const run::Layout& layout, const run::CellName& name,
             const ProblemsByFile& problems);

/// Without the folder of the run, wherever a text names a file in it.
std::string below_run(std::string text, const std::filesystem::path& run);

}  // namespace piae::page
