#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "augment/catalogue.hpp"
#include "cli/options.hpp"
#include "report/accuracies.hpp"
#include "report/document.hpp"
#include "run/collect.hpp"
#include "run/grid.hpp"
#include "run/held.hpp"
#include "run/layout.hpp"
#include "scoring/diagnosis_record.hpp"

namespace piae::report {

/// Part of a sweep that a table shows; [sweep] of pipeline/protocol.toml describes the whole sweep.
/// A sweep changes one setting of a method at a time and keeps the others as in the grid. The paper
/// does so with its own method (Section 4.5.5 and Fig. 19).
struct SweepOptions {
  std::string dataset = {};
  std::vector<std::string> points = {};  ///< "batch=1": an option of train and its value
  std::vector<std::string> centre = {};  ///< the points that equal the setting of the grid
  std::vector<std::string> ratios = {};
  std::vector<std::string> seeds = {};
  std::string method = augment::paper_method();
  std::string classifier = scoring::paper_classifier;
};

void bind(const cli::Options& command, SweepOptions& options);

/// A setting and one value of it.
struct SweepPoint {
  std::string factor;   ///< an option of train: "batch"; empty if nothing is changed
  std::string value;    ///< "1"
  bool centre = false;  ///< whether the grid has this very value
  /// Returns the folder of its cells below the folder of each seed: "sweep/batch-1". A centre uses
  /// the cells of the grid, in the folder of the method, so that nothing is computed twice.
  [[nodiscard]] std::string folder(const std::string& method) const;
};

struct Sweep {
  std::string method;
  std::string classifier;
  run::Grid grid;  ///< requested cells of this method by this classifier
  std::vector<SweepPoint> points;
};

/// Resolves the options. For a method other than the paper's, adds the unchanged method as the
/// first point. Throws Error(usage) as run::resolve() does, and for an unknown method, a point that
/// is not FACTOR=VALUE, and a centre that is not a point.
Sweep resolve(const SweepOptions& options);

/// One point at one ratio, over the seeds.
struct SweepRow {
  SweepPoint point;
  AccuracyRow accuracy;
};

/// Returns a row for each point and ratio, points in the requested order. In addition to the
/// requested seeds and ratios, a row has all at which the run holds a changed setting
/// (run/held.hpp). A point with a missing or refused cell has no row; `results` records what is
/// wrong with the cell.
std::vector<SweepRow> sweep_rows(const run::Layout& layout, const Sweep& sweep,
                                 const run::Held& held, run::Results& results);

/// Returns the seeds that any row has, ascending.
std::vector<std::int64_t> seeds_of_any_row(const std::vector<SweepRow>& rows);
/// Returns a note if any row has fewer than `all` seeds; "" otherwise.
std::string fewer_seeds_note(const std::vector<SweepRow>& rows, std::size_t all);

/// Returns sweep.csv: dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high in percent.
/// `seeds` is the number of seeds. Empty are the standard deviation of a single seed, and an
/// interval that no table shows (report/accuracies.hpp).
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows);

/// Returns the same for people: a table for each factor, with a block for each of its values.
Document sweep_document(const Sweep& sweep, const std::vector<SweepRow>& rows,
                        const run::Results& results);

}  // namespace piae::report
