#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "page/requested_cells.hpp"
#include "report/accuracies.hpp"
#include "report/report_tables.hpp"
#include "run/collect.hpp"
#include "run/layout.hpp"
#include "scoring/accuracy.hpp"
#include "signal/dataset_info.hpp"

namespace piae::page {

/// Why a cell is missing.
enum class MissingState {
  failed,       ///< a step on the way to it failed
  refused,      ///< it exists but is damaged, belongs to another cell, or was made under other
                ///< conditions
  interrupted,  ///< a step was stopped; the same command continues from there
  open,         ///< a step is running, or was killed
  not_started
};

/// A cell of the grid that is missing from all numbers of a page, and why.
struct MissingCell {
  run::CellName name;  ///< the ratio is empty for a score
  MissingState state = MissingState::not_started;
  std::string stage = {};          ///< stage that is not done; empty for a refused cell
  std::string why = {};            ///< reason of a failed or refused cell
  std::filesystem::path log = {};  ///< relative to the folder of the run; empty if none
};

/// Errors from collecting a data set, by the file that each names. There may be as many as cells.
class ProblemsByFile {
 public:
  ProblemsByFile(const run::Layout& layout, const std::vector<std::string>& problems);
  /// Returns the error on a file; "" if there was none.
  [[nodiscard]] std::string with(const std::filesystem::path& file) const;

 private:
  std::map<std::string, std::string> problems_;
};

/// Returns why a cell has no number in the results. `problems` are the errors from collecting it.
/// Paths are relative to the folder of the run, so that the text is the same in any folder.
MissingCell as_missing_cell(const std::filesystem::path& run, const run::Layout& layout,
                            const run::CellName& name, const ProblemsByFile& problems);

/// Removes the folder of the run from each path in a text.
std::string below_run(std::string text, const std::filesystem::path& run);

/// Program that made an artefact.
struct Build {
  std::string version;    ///< with commit
  std::string libraries;  ///< with compiler
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

/// Contents of a run for one data set. File names are relative to the folder of the run, so that
/// the same run gives the same page in any folder.
struct DatasetContents {
  std::string name;
  run::Grid grid = {};        ///< requested cells, and other cells that the folder holds
  run::Results results = {};  ///< the cells that could be read
  std::vector<std::string> diagnosis_digests = {};  ///< of the contents of results.diagnoses
  std::vector<std::string> score_digests = {};      ///< of the contents of results.qualities
  std::map<Build, std::size_t> builds = {};         ///< number of cells by build
  std::vector<MissingCell> missing_cells = {};
  std::vector<report::AccuracyRow> rows = {};  ///< accuracies, percent, by any classifier
  std::vector<std::string> verdict = {};       ///< sentences; the conditions come first
  report::ReportTables tables = {};
  std::string records_digest = {};   ///< empty without records
  std::string records_problem = {};  ///< why the records cannot be read; empty if they can
  std::vector<RecordInput> records = {};
};

/// Reads all cells of a data set, its records and the logs of missing cells. Missing or damaged
/// files are not errors but missing cells. `leave_out` are files that are out of date, as
/// for run::Held.
DatasetContents read_dataset(const std::filesystem::path& run, const run::Grid& requested,
                             const std::vector<std::string>& leave_out,
                             const report::Published& published);

/// Returns "3 diagnoses and 1 score".
std::string counted_cells(std::size_t diagnoses, std::size_t scores);

}  // namespace piae::page
