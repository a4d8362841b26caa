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

/// Which part of a sweep a table shows; [sweep] of pipeline/protocol.toml has all of it. In a sweep
/// one setting of a method at a time is moved, and all others stay as they are in the grid. The
/// paper does so with its own method (Section 4.5.5 and Fig. 19).
struct SweepOptions {
  std::string dataset = {};
  std::vector<std::string> points = {};  ///< "batch=1": an option of train, and its value
  std::vector<std::string> centre = {};  ///< those points that are the setting of the grid
  std::vector<std::string> ratios = {};
  std::vector<std::string> seeds = {};
  std::string method = augment::paper_method();
  std::string classifier = scoring::paper_classifier;
};

void bind(const cli::Options& command, SweepOptions& options);

/// One setting, and one value of it.
struct SweepPoint {
  std::string factor;   ///< an option of train: "batch"; empty where nothing is moved
  std::string value;    ///< "1"
  bool centre = false;  ///< whether the grid has this very value
  /// The folder of its cells below that of each seed: "sweep/batch-1". The cells of a centre are
  /// those of the grid, which are not computed twice; they are in the folder of the method.
  [[nodiscard]] std::string folder(const std::string& method) const;
};

struct Sweep {
  std::string method;
  std::string classifier;
  run::Grid grid;  ///< what is asked for: cells of this method by this classifier
  std::vector<SweepPoint> points;
};

/// Of another method than the paper's, the first point is the method as it is. Throws Error(usage)
/// as run::resolve() does, for an unknown method, for a point that is not FACTOR=VALUE, and for a
/// centre that is none of the points.
Sweep resolve(const SweepOptions& options);

/// One point at one ratio, over the seeds.
struct SweepRow {
  SweepPoint point;
  AccuracyRow accuracy;
};

/// A row for each point and ratio, points in the order asked for. Beside the seeds and ratios asked
/// for, a row has all those at which the run holds a moved setting (run/held.hpp). A point with a
/// cell that is missing or refused has no row; `results` says what is wrong with the cell.
std::vector<SweepRow> sweep_rows(const run::Layout& layout, const Sweep& sweep,
                                 const run::Held& held, run::Results& results);

/// All seeds of any row, ascending.
std::vector<std::int64_t> seeds_of_any_row(const std::vector<SweepRow>& rows);
/// What is to be said where not every row has so many seeds; else nothing.
std::string fewer_seeds_note(const std::vector<SweepRow>& rows, std::size_t all);

/// sweep.csv: dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high in percent; `seeds` is
/// how many there are. Empty are the standard deviation of a single seed, and an interval that no
/// table shows (report/accuracies.hpp).
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows);

/// The same for people: a table for each factor, with a block for each of its values.
Document sweep_document(const Sweep& sweep, const std::vector<SweepRow>& rows,
                        const run::Results& results);

}  // namespace piae::report
