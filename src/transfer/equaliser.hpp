#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "base/random.hpp"
#include "cli/options.hpp"

namespace piae::transfer {

/// How much a random transfer path differs from the one that is known.
struct EqualiserOptions {
  double spread_db = 0;  ///< standard deviation of the gain at a knot
  int knots = 8;         ///< from 0 Hz to half the sampling rate, at equal distances
};

/// Adds --equaliser-db and --equaliser-knots.
void bind(const cli::Options& command, EqualiserOptions& options);

/// In the artefact: the attributes spread_db and knots of the group /equaliser.
void write(artefact::Writer& writer, const EqualiserOptions& options);
EqualiserOptions read_equaliser_options(const artefact::Reader& reader);

/// The gain of a random smooth transfer path at `bins` frequencies from 0 Hz to half the sampling
/// rate: normal in dB at the knots, a straight line in dB between them. 1 is no change.
std::vector<double> draw_gains(Stream& random, std::size_t bins, const EqualiserOptions& options);

/// Multiplies the spectrum of a window by gains at its bins 0 .. length / 2, with no change of
/// phase; what leaves at its end comes in at its beginning. The RMS stays what it was, so only the
/// shape of the spectrum changes. Throws std::logic_error for another number of gains.
void equalise(std::span<double> window, std::span<const double> gains);

}  // namespace piae::transfer
