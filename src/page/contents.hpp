#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "page/asked.hpp"
#include "report/accuracies.hpp"
#include "report/recommendation.hpp"
#include "run/collect.hpp"
#include "run/layout.hpp"
#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

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

/// What an artefact says of the program that made it.
struct Build {
  std::string version;    ///< and commit
  std::string libraries;  ///< and compiler
  std::string processor;
  bool operator<(const Build& other) const {
    return std::tie(version, libraries, processor) <
           std::tie(other.version, other.libraries, other.processor);
  }
};

/// A recording, or a description from which recordings were simulated.
struct RecordInput {
  std::string file;
  std::string digest;
};

/// What a run holds of one data set. Files are named from the folder of the run on, so that the
/// same run gives the same page in any folder.
struct DatasetContents {
  std::string name;
  run::Grid grid = {};        ///< what is asked for, and what else the folder holds
  run::Results results = {};  ///< the cells that could be read
  std::vector<std::string> diagnosis_digests = {};  ///< of the contents of results.diagnoses
  std::vector<std::string> score_digests = {};      ///< of the contents of results.qualities
  std::map<Build, std::size_t> builds = {};         ///< how many of the cells each has made
  std::vector<Hole> holes = {};
  std::vector<report::AccuracyRow> rows = {};  ///< accuracies, percent, by any classifier
  std::vector<std::string> verdict = {};       ///< sentences; first its conditions
  std::vector<report::Recommendation> recommendations = {};  ///< by ratio
  std::string records_digest = {};                           ///< empty where there are no records
  std::string records_problem = {};  ///< why they cannot be read; empty where they can
  std::vector<RecordInput> records = {};
};

/// Reads all cells of a data set, its records and the logs of what is missing. Nothing that is
/// missing or damaged is an error: it is a hole.
/// `leave_out` is what is out of date, as for run::Held.
DatasetContents read_dataset(const std::filesystem::path& run, const run::Grid& asked,
                             const std::vector<std::string>& leave_out,
                             const report::Published& published);

/// "3 diagnoses and 1 score".
std::string counted_cells(std::size_t diagnoses, std::size_t scores);

}  // namespace piae::page
