#pragma once

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "cli/options.hpp"
#include "transfer/edge_fit.hpp"
#include "transfer/equaliser.hpp"
#include "transfer/healthy.hpp"
#include "transfer/strengths.hpp"

namespace piae::transfer {

/// Whether something of a window is set to the tested condition or left as it is known.
enum class Set { tested, known };

/// How the machine answers a blow: as its known spectrum says, with minimum phase; as eq. 13's ring
/// does (ring.hpp); or as what was cut from the known windows.
enum class Response { minimum_phase, ring, cut };

/// What colours that in a window which is not struck: the spectrum of the struck windows, or that
/// of healthy windows of the tested condition.
enum class BackgroundFrom { struck, healthy };

/// How windows are carried to the tested condition.
struct CarryOptions {
  Response response = Response::minimum_phase;
  Set edges = Set::tested;   ///< the lag between both edges of the defect
  Set rhythm = Set::tested;  ///< the time between strikes
  StrengthOptions strengths;
  double own_structure = 1;  ///< least part kept of what tells a bearing's structure from others'
  double background = 0;     ///< largest part of the power that is not struck
  BackgroundFrom background_from = BackgroundFrom::struck;
  double dispersion_ms = 0;  ///< of the random path's group delay: standard deviation
  double jitter = 0;         ///< of a strike: standard deviation / period
  double lag_deviation = 0;  ///< of the lag: standard deviation / lag
  double tilt = 0;           ///< largest power of the frequency for each doubling of the speed
  double size_factor = 1;    ///< how far beyond the known sizes one that is not known may lie
  EqualiserOptions equaliser;
  double other_bearing_db = 0;  ///< its spread_db where the tested bearing is not the known one
  double mass_kg = 1;           ///< M of eq. 13, by which a ring has its k and c
  EdgePrior prior;              ///< not stored: the edges that were found with it are
};

void bind(const cli::Options& command, CarryOptions& options);

/// Throws Error(usage) for options that do not go together, or not with what is known: a load zone
/// that ends before it begins, and a background of healthy windows where a tested condition has
/// none.
void require_sense(const CarryOptions& options, const signal::WindowSet& known,
                   const std::vector<HealthySpectrum>& healthy);

/// In the artefact: attributes of the groups /carry, /strengths and /equaliser.
void write(artefact::Writer& writer, const CarryOptions& options);
CarryOptions read_carry_options(const artefact::Reader& reader);

}  // namespace piae::transfer
