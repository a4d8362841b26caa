#pragma once

#include <array>
#include <optional>

#include "classification/verdict.hpp"

namespace piae::classification {

/// Side bands of a fault's line in the envelope spectrum: the line is modulated once a turn of the
/// shaft (a fault on the inner race passes the load zone) or of the cage (a fault on a ball).
struct SideBands {
  double spacing_hz = 0;
  double below_db = 0;  ///< height over the floor around the line, at the line minus the spacing
  double above_db = 0;  ///< at the line plus the spacing
  double limit_db = 0;  ///< white noise exceeds it in less than one record of a thousand

  /// Returns how many of the two exceed the limit.
  [[nodiscard]] int present() const {
    return static_cast<int>(below_db > limit_db) + static_cast<int>(above_db > limit_db);
  }
};

/// Heights of a fault's line and its harmonics.
struct LineEvidence {
  inspection::FaultLine line;
  double found_hz = 0;                   ///< within 2 % of line.hz; 0 if not measured
  std::array<double, 3> harmonics_db{};  ///< of 1, 2 and 3 times found_hz; their mean is line.db
  std::optional<SideBands> side_bands = {};  ///< of inner race and ball, if present

  [[nodiscard]] bool has_harmonic(int number) const {
    return found_hz > 0 && harmonics_db.at(static_cast<std::size_t>(number - 1)) > line.noise_db;
  }
};

/// Returns the evidence for outer race, inner race and ball. Without a described bearing, or for a
/// recording that is too short, lines are not measured.
std::array<LineEvidence, 3> line_evidence(const Verdict& verdict, const signal::DatasetInfo& info);

}  // namespace piae::classification
