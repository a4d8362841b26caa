#pragma once

#include <optional>
#include <vector>

#include "artefact/reader.hpp"
#include "report/accuracy_table.hpp"
#include "run/collect.hpp"
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

/// What the figures of a dataset are drawn from: the cells of its grid in the folder of a run.
/// Cells are read when a figure first asks for them. All members throw Error in one line, which
/// names the first file that is missing or refused, and says how many others are.
class Source {
 public:
  Source(run::Layout layout, run::Grid grid, report::Published published)
      : layout_(std::move(layout)), grid_(std::move(grid)), published_(std::move(published)) {}

  [[nodiscard]] const run::Layout& layout() const { return layout_; }
  [[nodiscard]] const run::Grid& grid() const { return grid_; }

  /// The methods of the grid that infer stiffness and damping, in its order. Never empty.
  [[nodiscard]] std::vector<std::string> inferring_methods() const;

  /// Of every diagnosis of the grid.
  const std::vector<report::AccuracyRow>& accuracy_rows();
  /// Every score of the grid, by method, then seed.
  const std::vector<scoring::QualityRecord>& qualities();
  /// One diagnosis with everything that it says of the test windows.
  [[nodiscard]] scoring::DiagnosisRecord diagnosis(const run::Combination& cell,
                                                   std::int64_t seed) const;
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
  run::Grid grid_;
  report::Published published_;
  std::optional<std::vector<report::AccuracyRow>> rows_;
  std::optional<std::vector<scoring::QualityRecord>> qualities_;
};

}  // namespace piae::figures
