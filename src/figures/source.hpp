#pragma once

#include <optional>
#include <vector>

#include "artefact/reader.hpp"
#include "report/classifier_rows.hpp"
#include "run/held.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::figures {

/// Thrown where a run is without what a figure shows, such as a method that was not asked for.
/// Nothing is wrong then: the figure is left out.
class LeftOut : public Error {
 public:
  explicit LeftOut(const std::string& line) : Error(Exit::input_missing, line) {}
};

/// Throws Error in one line where any cell is missing or refused: it names the first, and says how
/// many others are.
void require_whole(const run::Results& results);

/// What the figures of a dataset are drawn from: the cells that are asked for, which must be there,
/// and all others that the folder of the run holds, as for tables (run/held.hpp). Cells are read
/// when a figure first asks for them. All members throw Error in one line, which names the first
/// file that is missing or refused, and says how many others are.
class Source {
 public:
  /// `leave_out` is what is out of date, as for run::Held. Throws Error(input_missing) where no
  /// cell is asked for and none is there.
  Source(run::Layout layout, run::Grid asked, report::Published published,
         const std::vector<std::string>& leave_out = {});

  [[nodiscard]] const run::Layout& layout() const { return layout_; }
  /// Of those of these cells that are by the paper's classifier; not every combination has every
  /// seed.
  [[nodiscard]] const run::Grid& grid() const { return grid_; }

  /// What figures show that have room for one seed: the lowest.
  [[nodiscard]] std::int64_t shown_seed() const { return grid_.seeds.front(); }
  /// Whether a file of a method and seed is needed by figures, as its cell is asked for, or else is
  /// there.
  [[nodiscard]] bool has(const std::string& method, std::int64_t seed,
                         const std::filesystem::path& file) const;
  /// The seeds of a cell, ascending.
  [[nodiscard]] std::vector<std::int64_t> seeds_of(const run::Combination& cell) const;

  /// The methods that infer stiffness and damping, in the order of the grid, and have a model of
  /// the shown seed. Never empty.
  [[nodiscard]] std::vector<std::string> inferring_methods() const;

  /// Every diagnosis that could be read, what is wrong with the others, and what is left out.
  const run::Results& results();
  /// The accuracies by each classifier, the paper's first; all diagnoses must be there.
  const std::vector<report::ClassifierRows>& accuracies();
  /// Every score, by method, then seed.
  const std::vector<scoring::QualityRecord>& qualities();
  /// The diagnoses of a cell at these seeds, with everything that they say of the test windows.
  [[nodiscard]] std::vector<scoring::DiagnosisRecord> diagnoses(
      const run::Combination& cell, const std::vector<std::int64_t>& seeds) const;
  /// The same with the features of the test windows, which are kept of some cells.
  [[nodiscard]] scoring::DiagnosisRecord features(const run::Combination& cell,
                                                  std::int64_t seed) const;
  /// The model of a method, which must be in the grid.
  [[nodiscard]] artefact::Reader model(const std::string& method, std::int64_t seed) const;

 private:
  [[nodiscard]] scoring::DiagnosisRecord read(const artefact::Reader& reader,
                                              const run::Combination& cell,
                                              std::int64_t seed) const;

  run::Layout layout_;
  run::Grid asked_;
  run::Held held_;
  run::Grid grid_;
  report::Published published_;
  std::optional<run::Collected> diagnoses_;
  std::optional<std::vector<report::ClassifierRows>> accuracies_;
  std::optional<std::vector<scoring::QualityRecord>> qualities_;
};

}  // namespace piae::figures
