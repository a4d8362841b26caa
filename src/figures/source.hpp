#pragma once

#include <optional>
#include <vector>

#include "artefact/reader.hpp"
#include "report/accuracies.hpp"
#include "run/held.hpp"
#include "run/step_costs.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::figures {

/// Thrown if a run lacks the data of a figure, such as a method that was not requested. This is not
/// an error: the figure is left out.
class LeftOut : public Error {
 public:
  explicit LeftOut(const std::string& line) : Error(Exit::input_missing, line) {}
};

/// Throws Error in one line if any cell is missing or refused: it names the first, and counts the
/// others.
void require_whole(const run::Results& results);

/// Data for the figures of a data set: the requested cells, which must exist, and all others in the
/// run's folder, as for tables (run/held.hpp). Cells are read when a figure first needs them. All
/// members throw Error in one line, which names the first missing or refused file, and counts the
/// others.
class Source {
 public:
  /// Opens a run; `leave_out` lists stale files, as for run::Held. Throws Error(input_missing) if
  /// no cell is requested and none exists.
  Source(run::Layout layout, run::Grid requested, report::Published published,
         const std::vector<std::string>& leave_out = {}, std::vector<run::StepCost> costs = {});

  [[nodiscard]] const run::Layout& layout() const { return layout_; }
  /// Returns the grid of the cells with the paper's classifier; not every combination has every
  /// seed.
  [[nodiscard]] const run::Grid& grid() const { return grid_; }

  /// Returns the lowest seed, for figures that show only one.
  [[nodiscard]] std::int64_t shown_seed() const { return grid_.seeds.front(); }
  /// True if figures need a file of a method and seed, because its cell is requested, or the file
  /// exists.
  [[nodiscard]] bool has(const std::string& method, std::int64_t seed,
                         const std::filesystem::path& file) const;
  /// Returns the seeds of a cell, ascending.
  [[nodiscard]] std::vector<std::int64_t> seeds_of(const run::Combination& cell) const;

  /// Returns the methods that infer stiffness and damping and have a model of the shown seed, in
  /// the order of the grid. Never empty.
  [[nodiscard]] std::vector<std::string> inferring_methods() const;

  /// Returns the costs of steps in an earlier run; empty if none were given.
  [[nodiscard]] const std::vector<run::StepCost>& costs() const { return costs_; }

  /// Returns all readable diagnoses, the errors of the others, and what is left out.
  const run::Results& results();
  /// Returns the accuracies by classifier, the paper's first; all diagnoses must exist.
  const std::vector<report::ClassifierRows>& accuracies();
  /// Returns all scores, by method, then seed.
  const std::vector<scoring::QualityRecord>& qualities();
  /// Returns the diagnoses of a cell at these seeds, with all their data on the test windows.
  [[nodiscard]] std::vector<scoring::DiagnosisRecord> diagnoses(
      const run::Combination& cell, const std::vector<std::int64_t>& seeds) const;
  /// Returns a diagnosis with the features of the test windows, which some cells store.
  [[nodiscard]] scoring::DiagnosisRecord features(const run::Combination& cell,
                                                  std::int64_t seed) const;
  /// Returns the model of a method, which must be in the grid.
  [[nodiscard]] artefact::Reader model(const std::string& method, std::int64_t seed) const;

 private:
  [[nodiscard]] scoring::DiagnosisRecord read(const artefact::Reader& reader,
                                              const run::Combination& cell,
                                              std::int64_t seed) const;

  run::Layout layout_;
  run::Grid requested_;
  run::Held held_;
  run::Grid grid_;
  report::Published published_;
  std::vector<run::StepCost> costs_;
  std::optional<run::Collected> diagnoses_;
  std::optional<std::vector<report::ClassifierRows>> accuracies_;
  std::optional<std::vector<scoring::QualityRecord>> qualities_;
};

}  // namespace piae::figures
