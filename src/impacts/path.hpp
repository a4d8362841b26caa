#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "cli/stored_options.hpp"

namespace piae::impacts {

/// How much a random transfer path differs from the known one.
struct EqualiserOptions {
  double spread_db = 0;  ///< standard deviation of the gain at a knot
  int knots = 8;         ///< from 0 Hz to half the sampling rate, at equal distances
};

/// Adds --equaliser-db and --equaliser-knots, which are the attributes spread_db and knots of the
/// group /equaliser.
void add_to(cli::StoredOptions& table, EqualiserOptions& options);

/// Straight lines between values at knots, which lie from the first of `bins` to the last.
Eigen::ArrayXd along_knots(std::span<const double> knots, Eigen::Index bins);

/// Gain of a random smooth transfer path at `bins` frequencies from 0 Hz to half the sampling rate:
/// normal in dB at the knots, a straight line in dB between them. 1 changes nothing.
Eigen::ArrayXd draw_gains(Stream& random, Eigen::Index bins, const EqualiserOptions& options);

/// Multiplies the spectrum of a window by gains, as filter() of response.hpp does, without changing
/// phases or the RMS. Throws std::logic_error for another number of gains.
void equalise(std::span<double> window, const Eigen::ArrayXd& gains);

}  // namespace piae::impacts
