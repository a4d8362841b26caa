#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "cli/stored_options.hpp"

namespace piae::impacts {

/// Deviation of a random transfer path from the known one.
struct EqualiserOptions {
  double spread_db = 0;  ///< standard deviation of the gain at a knot
  int knots = 8;         ///< equally spaced from 0 Hz to half the sampling rate
};

/// Adds --equaliser-db and --equaliser-knots, stored as the attributes spread_db and knots of the
/// group /equaliser.
void add_to(cli::StoredOptions& table, EqualiserOptions& options);

/// Interpolates linearly between values at knots, which lie from the first of `bins` to the last.
Eigen::ArrayXd along_knots(std::span<const double> knots, Eigen::Index bins);

/// Returns the gain of a random smooth transfer path at `bins` frequencies from 0 Hz to half the
/// sampling rate: normal in dB at the knots, linear in dB between them. A gain of 1 changes
/// nothing.
Eigen::ArrayXd draw_gains(Stream& random, Eigen::Index bins, const EqualiserOptions& options);

/// Multiplies the spectrum of a window by gains, like filter() of response.hpp, and keeps phases
/// and RMS. Throws std::logic_error if the number of gains is wrong.
void equalise(std::span<double> window, const Eigen::ArrayXd& gains);

}  // namespace piae::impacts
