#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"
#include "run/collect.hpp"
#include "report/document.hpp"
#include "run/grid.hpp"
#include "run/layout.hpp"
#include "scoring/statistics.hpp"

namespace piae::report {

/// Whose settings are moved one at a time, all others staying where they are (paper 4.5.5, Fig.
/// 19).
inline const std::string swept_method = "piae-dt";

/// The part of a sweep that a table shows. [sweep] of pipeline/protocol.toml has the whole.
struct SweepOptions {
  std::string dataset;
  std::vector<std::string>
      points;  ///< "batch=1": a factor, which is an option of train, and a value
  std::vector<std::string> centre;  ///< those points that are the method as the grid has it
  std::vector<std::string> ratios;
  std::vector<std::string> seeds;
};

void bind(const cli::Options& command, SweepOptions& options);

struct SweepPoint {
  std::string factor;
  std::string value;
  bool centre = false;
  /// Of its cells, within those of the seeds: that of the method for a centre, which is not
  /// computed twice, else "sweep/batch-1".
  [[nodiscard]] std::string folder() const {
    return centre ? swept_method : "sweep/" + factor + "-" + value;
  }
};

struct Sweep {
  run::Grid grid;  ///< the swept method alone
  std::vector<SweepPoint> points;
};

/// Lists may also come as one value with commas or spaces in it. Throws Error(usage) as for a grid,
/// for a point that is not FACTOR=VALUE, and for a centre that is no point.
Sweep resolve(const SweepOptions& options);

/// One point at one ratio over the seeds, in percent.
struct SweepRow {
  SweepPoint point;
  std::string ratio;
  double true_ratio = 0;
  scoring::Summary summary;
};

/// One row for each point and ratio, points as asked for. What is missing or refused is in
/// `results`, and has no row.
std::vector<SweepRow> sweep_rows(const run::Layout& layout, const Sweep& sweep, run::Results& results);

/// sweep.csv: dataset,factor,value,ratio,seeds,mean,std,ci95_low,ci95_high in percent; `seeds` is
/// how many there are; std and interval of one seed alone are empty.
std::string sweep_csv(const Sweep& sweep, const std::vector<SweepRow>& rows);

/// The same for people, a table for each factor with a ratio a column.
Document sweep_document(const Sweep& sweep, const std::vector<SweepRow>& rows,
                        const run::Results& results);

}  // namespace piae::report
